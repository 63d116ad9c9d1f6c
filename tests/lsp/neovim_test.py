#!/usr/bin/env python3
"""Neovim's own client against the language server; exit status 77 where there is no Neovim."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

if not shutil.which("nvim"):
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    scene = folder / "scene.pov"
    scene.write_text("#version 3.7; global_settings { assumed_gamma 1 }\ncamera { location -5*z look_at 0 }\n"
                     "sphere { 0, Raduis }\nlight_source { <20, 30, -40>, rgb 1 }\n")
    environment = dict(os.environ, HOME=str(folder), XDG_CONFIG_HOME=str(folder), XDG_STATE_HOME=str(folder),
                       NEOVIM_SERVER=str(pathlib.Path(sys.argv[1]).resolve()), NEOVIM_SCENE=str(scene),
                       NEOVIM_RESULT=str(folder / "result.json"))
    run = subprocess.run(["nvim", "--headless", "--clean", "-n", "-S", str(pathlib.Path(__file__).with_name("neovim.lua"))],
                         env=environment, cwd=folder, capture_output=True, timeout=90, text=True)
    result = json.loads((folder / "result.json").read_text())
    print(result, run.stderr)
    assert run.returncode == 0, run.stderr
    assert result["diagnostic"]["line"] == 2 and result["diagnostic"]["column"] == 12, result
    assert "Raduis" in result["diagnostic"]["message"], result
    assert "Where the picture is seen from" in result["hover"], result
    assert result["mended"], result
