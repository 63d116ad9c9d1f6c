"""A client of the Language Server Protocol: as much of it as the tests need."""
import json
import os
import pathlib
import subprocess
import threading
import time
import urllib.parse


def uri_of(path):
    return "file://" + urllib.parse.quote(str(path))


class ServerDied(Exception):
    pass


class Client:
    """Talks to `verisim lsp`; positions are (line, column in UTF-16 units)."""

    def __init__(self, program, *options, cwd=None, capabilities=None):
        self.server = subprocess.Popen([program, "lsp", *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, cwd=cwd)
        self.next_id, self.answers, self.diagnostics, self.versions = 0, {}, {}, {}
        self.published = {}  # how often, by URI
        self.changed = threading.Condition()
        self.closed = False
        threading.Thread(target=self._listen, daemon=True).start()
        self.texts = {}
        self.initialized = self.ask("initialize", {"processId": os.getpid(), "rootUri": None,
                                                   "capabilities": capabilities or {}})
        self.tell("initialized", {})

    def _listen(self):
        stream = self.server.stdout
        while True:
            length = None
            while (line := stream.readline().strip()):
                name, _, value = line.partition(b":")
                if name.lower() == b"content-length":
                    length = int(value)
            if length is None:
                break
            message = json.loads(stream.read(length))
            with self.changed:
                if "method" in message:
                    if message["method"] == "textDocument/publishDiagnostics":
                        p = message["params"]
                        self.diagnostics[p["uri"]] = p["diagnostics"]
                        self.versions[p["uri"]] = p.get("version")
                        self.published[p["uri"]] = self.published.get(p["uri"], 0) + 1
                else:
                    self.answers[message["id"]] = message
                self.changed.notify_all()
        with self.changed:
            self.closed = True
            self.changed.notify_all()

    def send(self, message):
        body = json.dumps(message).encode()
        self.server.stdin.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.server.stdin.flush()

    def tell(self, method, params):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def ask_raw(self, method, params, timeout=60):
        self.next_id += 1
        number = self.next_id
        self.send({"jsonrpc": "2.0", "id": number, "method": method, "params": params})
        with self.changed:
            if not self.changed.wait_for(lambda: number in self.answers or self.closed, timeout):
                raise TimeoutError(method)
            if number not in self.answers:
                raise ServerDied(method + ": " + self.server.stderr.read().decode(errors="replace"))
            return self.answers.pop(number)

    def ask(self, method, params, timeout=60):
        answer = self.ask_raw(method, params, timeout)
        if "error" in answer:
            raise RuntimeError(answer["error"]["message"])
        return answer["result"]

    # ---- documents ----
    def open(self, path, text=None, language="pov"):
        uri = path if str(path).startswith("untitled:") else uri_of(path)
        text = pathlib.Path(path).read_bytes().decode("utf-8", "replace") if text is None else text
        self.texts[uri] = (1, text)
        self.tell("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": language, "version": 1, "text": text}})
        return uri

    def edit(self, uri, begin, end, with_text):
        """Replaces [begin, end) of the text, offsets in characters."""
        version, text = self.texts[uri]
        change = {"range": {"start": self.position(text, begin), "end": self.position(text, end)}, "text": with_text}
        self.texts[uri] = (version + 1, text[:begin] + with_text + text[end:])
        self.tell("textDocument/didChange", {"textDocument": {"uri": uri, "version": version + 1},
                                             "contentChanges": [change]})

    def write(self, uri, text):
        self.edit(uri, 0, len(self.texts[uri][1]), text)

    def close(self, uri):
        self.tell("textDocument/didClose", {"textDocument": {"uri": uri}})
        del self.texts[uri]

    @staticmethod
    def position(text, offset):
        before = text[:offset].replace("\r\n", "\n").replace("\r", "\n")
        line = before.rsplit("\n", 1)[-1]
        return {"line": before.count("\n"), "character": len(line.encode("utf-16-le")) // 2}

    def at(self, uri, mark, method, **more):
        """Asks about the place right behind `mark` (its last character is the place)."""
        text = self.texts[uri][1]
        found = text.index(mark) + len(mark)
        return self.ask("textDocument/" + method, {"textDocument": {"uri": uri}, "position": self.position(text, found),
                                                   **more})

    def of(self, uri, method, **more):
        return self.ask("textDocument/" + method, {"textDocument": {"uri": uri}, **more})

    def wait_for_diagnostics(self, uri, timeout=60):
        """The diagnostics of the text as it is now."""
        version = self.texts[uri][0]
        with self.changed:
            good = self.changed.wait_for(
                lambda: self.closed or (uri in self.published and (self.versions[uri] or 0) >= version), timeout)
            if self.closed:
                raise ServerDied(self.server.stderr.read().decode(errors="replace"))
            if not good:
                raise TimeoutError("diagnostics of " + uri)
            return self.diagnostics[uri]

    def stop(self):
        self.ask("shutdown", None)
        self.tell("exit", None)
        return self.server.wait(30)


def apply_edits(text, edits):
    """The text after TextEdits of the protocol; columns count UTF-16 units."""
    lines, starts = text.splitlines(keepends=True), [0]
    for line in lines:
        starts.append(starts[-1] + len(line))

    def offset(p):
        if p["line"] >= len(lines):
            return len(text)
        units, column = 0, 0
        for c in lines[p["line"]]:
            if units >= p["character"]:
                break
            units += 2 if ord(c) > 0xFFFF else 1
            column += 1
        return starts[p["line"]] + column
    for edit in sorted(edits, key=lambda e: offset(e["range"]["start"]), reverse=True):
        text = text[:offset(edit["range"]["start"])] + edit["newText"] + text[offset(edit["range"]["end"]):]
    return text
