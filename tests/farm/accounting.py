"""Slurm's accounting for a Slurm of slurm.py: a MariaDB and slurmdbd of our own (packages mariadb-server and slurmdbd), which many clusters have."""
import shutil
import signal
import subprocess
import time

from slurm import free_port


def why_not():
    missing = [p for p in ("mariadb-install-db", "mariadbd", "slurmdbd", "sacctmgr", "sacct") if not shutil.which(p)]
    return f"the packages slurmdbd and mariadb-server are missing ({', '.join(missing)})" if missing else ""


class Accounting:
    """From here on the Slurm forgets jobs after two seconds, and sacct knows them; a context."""

    def __init__(self, slurm):
        self.slurm, self.folder, self.daemons = slurm, slurm.folder, []
        self.plain = slurm.conf.read_text()

    def __enter__(self):
        folder, database, port = self.folder, free_port(), free_port()
        subprocess.run(["mariadb-install-db", "--no-defaults", f"--datadir={folder}/database", "--user=root", "--skip-test-db",
                        "--auth-root-authentication-method=normal"], check=True, capture_output=True)
        self.start("mariadbd", "--no-defaults", f"--datadir={folder}/database", f"--socket={folder}/database.socket", f"--port={database}",
                   "--bind-address=127.0.0.1", "--user=root", "--skip-grant-tables")
        self.slurm.until((folder / "database.socket").exists, "the database does not start")
        file = folder / "slurmdbd.conf"
        file.write_text(f"AuthType=auth/munge\nAuthInfo=socket={folder}/munge.socket\nDbdHost=localhost\nDbdAddr=127.0.0.1\nDbdPort={port}\n"
                        f"SlurmUser=root\nPidFile={folder}/slurmdbd.pid\nStorageType=accounting_storage/mysql\nStorageHost=127.0.0.1\n"
                        f"StoragePort={database}\nStorageUser=root\nStorageLoc=accounts\n")
        file.chmod(0o600)
        self.start("slurmdbd", "-D")
        self.slurm.conf.write_text(self.plain.replace("MinJobAge=600", "MinJobAge=2") + "AccountingStorageType=accounting_storage/slurmdbd\n"
                                   f"AccountingStorageHost=127.0.0.1\nAccountingStoragePort={port}\n"
                                   f"AccountingStoragePass={folder}/munge.socket\n")
        self.slurm.until(lambda: subprocess.run(["sacctmgr", "-i", "add", "cluster", "test"], capture_output=True).returncode == 0,
                         "slurmdbd does not answer")
        self.restart()

    def __exit__(self, *_):
        self.slurm.conf.write_text(self.plain)
        self.restart()
        for daemon in reversed(self.daemons):
            daemon.terminate()
            daemon.wait(60)

    def start(self, *call):
        with open(self.folder / f"{call[0]}.log", "w") as log:
            self.daemons.append(subprocess.Popen(call, stdout=log, stderr=log))

    def restart(self):
        self.slurm.kill("slurmctld", signal.SIGTERM)
        self.slurm.until(lambda: not self.slurm.answers(), "slurmctld does not end")
        time.sleep(1)
        self.slurm.start("slurmctld")
        self.slurm.until(lambda: self.slurm.ask("sinfo", "-h", "-o", "%T %D").strip() == "idle 2", "the nodes do not come back")
