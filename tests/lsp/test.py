#!/usr/bin/env python3
"""Sessions with the language server: what an editor asks, and what it must be told.

    test.py VERISIM
"""
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time
import unittest

from client import Client, apply_edits, uri_of

VERISIM = str(pathlib.Path(sys.argv[1]).resolve())
SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#include "parts.inc"
// A wheel with spokes.
// Radius: of the rim.
#macro Wheel(Radius, Spokes)
  #local Thin = 0.1;
  torus { Radius, Thin }
#end
#declare Red = rgb <1, 0, 0>;
camera { location <0, 2, -8> look_at 0 }
light_source { <20, 30, -40>, rgb 1 }
union {
  Wheel(2, 8)
  Wheel(Size, 12)
  pigment { Red }
}
"""
PARTS = "// How large.\n#declare Size = 2.5;\n"


class Session(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name).resolve()
        (self.folder / "scene.pov").write_text(SCENE)
        (self.folder / "parts.inc").write_text(PARTS)
        self.client = Client(VERISIM, "--delay", "10", "--read-seconds", "2", cwd=self.folder)

    def tearDown(self):
        self.assertEqual(self.client.stop(), 0)
        for stream in (self.client.server.stdin, self.client.server.stdout, self.client.server.stderr):
            stream.close()
        self.temporary.cleanup()

    def open(self, text=SCENE, name="scene.pov"):
        uri = self.client.open(self.folder / name, text)
        self.client.wait_for_diagnostics(uri)
        return uri

    def labels(self, uri, mark):
        return [item["label"] for item in self.client.at(uri, mark, "completion")["items"]]


class Diagnostics(Session):
    def test_a_good_scene_has_none(self):
        self.assertEqual(self.client.diagnostics[self.open()], [])

    def test_several_mistakes_are_told_at_their_words(self):
        uri = self.open(SCENE.replace("look_at", "look_att").replace("{ Red }", "{ Redd }"))
        found = [(d["code"], d["range"]["start"], d["range"]["end"]) for d in self.client.diagnostics[uri]]
        self.assertIn(("undeclared-identifier", {"line": 15, "character": 12}, {"line": 15, "character": 16}), found)
        self.assertIn({"line": 10, "character": 29}, [start for _, start, _ in found])

    def test_what_is_typed_counts_not_what_is_saved(self):
        uri = self.open()
        offset = SCENE.index("2, 8")
        self.client.edit(uri, offset, offset + 4, "2")
        diagnostics = self.client.wait_for_diagnostics(uri)
        self.assertEqual([d["code"] for d in diagnostics], ["macro-arguments"])
        self.client.edit(uri, offset, offset + 1, "2, 8")
        self.assertEqual(self.client.wait_for_diagnostics(uri), [])

    def test_an_unsaved_include_counts(self):
        uri, parts = self.open(), self.open(PARTS, "parts.inc")
        self.client.edit(parts, 0, len(PARTS), "#declare Sise = 2.5;\n")
        self.client.wait_for_diagnostics(parts)
        deadline = time.time() + 20
        while not self.client.diagnostics[uri] and time.time() < deadline:
            time.sleep(0.01)
        self.assertEqual([d["code"] for d in self.client.diagnostics[uri]], ["undeclared-identifier"])

    def test_an_include_is_read_as_a_part_of_its_scene(self):
        (self.folder / "parts.inc").write_text(PARTS + "sphere { 0, Radius_of_scene }\n")
        (self.folder / "scene.pov").write_text(SCENE.replace("#include", "#declare Radius_of_scene = 1;\n#include"))
        uri = self.client.open(self.folder / "parts.inc")
        self.assertEqual(self.client.wait_for_diagnostics(uri), [])

    def test_where_the_block_was_opened_is_told(self):
        uri = self.open(SCENE.replace("{ Red }", "{ Red look_at 0 }"))
        diagnostic = self.client.diagnostics[uri][0]
        self.assertEqual(diagnostic["code"], "unexpected-token")
        self.assertEqual(diagnostic["relatedInformation"][0]["location"]["range"]["start"], {"line": 15, "character": 2})

    def test_an_endless_loop_ends(self):
        begin = time.time()
        uri = self.open(SCENE + "#while (1) #end\n")
        self.assertEqual([d["severity"] for d in self.client.diagnostics[uri]], [3])
        self.assertLess(time.time() - begin, 20)
        # While it runs, a change is answered at once.
        self.client.write(uri, SCENE + "#while (1) #local A = 1; #end\n")
        time.sleep(0.1)
        self.client.write(uri, SCENE)
        begin = time.time()
        self.assertEqual(self.client.wait_for_diagnostics(uri), [])
        self.assertLess(time.time() - begin, 1.5)

    def test_nothing_is_written_to_the_disk(self):
        before = sorted(os.listdir(self.folder))
        uri = self.open(SCENE + '#fopen F "written.txt" write #write (F, 1, 2) #fclose F\n'
                        '#fopen F "parts.inc" append #write (F, "x") #fclose F\n')
        self.assertEqual([d for d in self.client.diagnostics[uri] if d["severity"] == 1], [])
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        self.assertEqual((self.folder / "parts.inc").read_text(), PARTS)

    def test_they_are_those_of_check(self):
        text = SCENE.replace("2, 8", "2").replace("rgb 1", "rgbx 1")
        uri = self.open(text)
        (self.folder / "scene.pov").write_text(text)
        run = subprocess.run([VERISIM, "check", "scene.pov", "--json"], cwd=self.folder, capture_output=True)
        import json
        wanted = sorted((d["code"], d["line"] - 1) for d in json.loads(run.stdout)["diagnostics"])
        self.assertEqual(sorted((d["code"], d["range"]["start"]["line"]) for d in self.client.diagnostics[uri]), wanted)

    def test_closing_takes_them_back(self):
        uri = self.open(SCENE.replace("2, 8", "2"))
        count = self.client.published[uri]
        self.client.close(uri)
        with self.client.changed:
            self.assertTrue(self.client.changed.wait_for(lambda: self.client.published[uri] > count, 20))
        self.assertEqual(self.client.diagnostics[uri], [])

    def test_a_file_without_a_name_is_read(self):
        uri = self.client.open("untitled:Untitled-1", "#version 3.7;\nsphere { 0, Raduis }\n")
        self.assertIn("undeclared-identifier", [d["code"] for d in self.client.wait_for_diagnostics(uri)])


class Hints(Session):
    TEXT = SCENE + "#declare Lonely = 1;\n#if (0)\n#elif (1)\n#end\n"

    UNUSED, SKIPPED = ("unused-name", [1]), ("skipped-directive", None)

    def expect(self, client, uri, wanted):
        """Hints may come a moment after the rest."""
        def hints():
            return [(d["code"], d.get("tags")) for d in client.diagnostics[uri] if d["severity"] == 4]
        client.wait_for_diagnostics(uri)
        with client.changed:
            client.changed.wait_for(lambda: hints() == wanted, 10)
        self.assertEqual(hints(), wanted)

    def test_are_the_lints_of_check(self):
        uri = self.open(self.TEXT)
        self.expect(self.client, uri, [self.UNUSED, self.SKIPPED])
        explained = self.client.ask("workspace/executeCommand",
                                    {"command": "verisim.explainCode", "arguments": ["unused-name"]})
        self.assertIn("used nowhere", explained["text"])

    def test_see_what_is_not_saved(self):
        uri = self.open(self.TEXT)
        self.client.write(uri, self.TEXT + "sphere { 0, Lonely }\n")
        self.expect(self.client, uri, [self.SKIPPED])

    def test_can_be_switched_off(self):
        for options, wanted in ((["none"], []), (["unused-name"], [self.UNUSED])):
            client = Client(VERISIM, *(word for name in options for word in ("--lint", name)), cwd=self.folder)
            uri = client.open(self.folder / "scene.pov", self.TEXT)
            self.expect(client, uri, wanted)
            client.stop()
            for stream in (client.server.stdin, client.server.stdout, client.server.stderr):
                stream.close()


class Meaning(Session):
    def hover(self, uri, mark):
        found = self.client.at(uri, mark, "hover")
        return found and found["contents"]["value"]

    def test_of_keywords_where_they_stand(self):
        uri = self.open()
        self.assertIn("torus { MAJOR, MINOR }", self.hover(uri, "  tor"))
        self.assertIn("how wide the view is", self.hover(self.open(SCENE.replace("look_at 0", "angle 40"), "b.pov"),
                                                         " angl").lower())
        self.assertIn("#macro NAME", self.hover(uri, "#mac"))

    def test_of_names_with_value_place_and_comment(self):
        uri = self.open()
        size = self.hover(uri, "Wheel(Siz")
        self.assertIn("#declare Size = 2.5", size)
        self.assertIn("How large.", size)
        self.assertIn("parts.inc, line 2", size)
        self.assertIn("#ff0000", self.hover(uri, "pigment { Re"))
        wheel = self.hover(uri, "union {\n  Whe")
        self.assertIn("#macro Wheel(Radius, Spokes)", wheel)
        self.assertIn("Radius: of the rim.", wheel)

    def test_nothing_of_comments_and_numbers(self):
        uri = self.open()
        self.assertIsNone(self.hover(uri, "// A whe"))
        self.assertIsNone(self.hover(uri, "<0, 2"))

    def test_signatures(self):
        uri = self.open()
        help_ = self.client.at(uri, "Wheel(2, ", "signatureHelp")
        self.assertEqual(help_["signatures"][0]["label"], "Wheel(Radius, Spokes)")
        self.assertEqual(help_["activeParameter"], 1)
        other = self.open(SCENE + "#declare A = vrotate(<1, x, 3>, <", "b.pov")
        help_ = self.client.at(other, "vrotate(<1, x, 3>, ", "signatureHelp")
        self.assertEqual((help_["signatures"][0]["label"], help_["activeParameter"]), ("vrotate(V, <X, Y, Z>)", 1))

    def test_columns_count_units_of_utf16(self):
        uri = self.open('#version 3.7;\n#declare A = 1;\n#debug "\U0001F600" #declare B = A + Missing;\n')
        place = [d["range"]["start"] for d in self.client.diagnostics[uri] if d["code"] == "undeclared-identifier"]
        self.assertEqual(place, [{"line": 2, "character": 29}])


class Completion(Session):
    def test_words_of_the_block(self):
        uri = self.open(SCENE.replace("{ Red }", "{ Red } finish { ph }"))
        words = self.labels(uri, "finish { ph")
        self.assertIn("phong", words)
        self.assertNotIn("look_at", words)

    def test_directives(self):
        words = self.labels(self.open(SCENE + "\n#"), "}\n\n#")
        self.assertIn("declare", words)
        self.assertNotIn("sphere", words)

    def test_statements_and_names(self):
        words = self.labels(self.open(SCENE + "\n s"), "}\n\n s")
        for word in ("sphere", "Wheel", "Size", "Red"):
            self.assertIn(word, words)
        self.assertNotIn("Thin", words)  # of the macro
        self.assertNotIn("phong", words)

    def test_a_macro_brings_its_parameters(self):
        uri = self.open(SCENE + "\nWh")
        item = [i for i in self.client.at(uri, "}\n\nWh", "completion")["items"] if i["label"] == "Wheel"][0]
        self.assertEqual(item["textEdit"]["newText"], "Wheel(${1:Radius}, ${2:Spokes})")

    def test_files(self):
        (self.folder / "bark.png").write_bytes(b"")
        uri = self.open(SCENE.replace("parts.inc", "pa"))
        self.assertEqual([n for n in self.labels(uri, '#include "pa') if n.startswith("pa")], ["parts.inc"])
        uri = self.open(SCENE + 'pigment { image_map { png "', "b.pov")
        self.assertIn("bark.png", self.labels(uri, 'png "'))


class Names(Session):
    def test_definition(self):
        uri = self.open()
        place = self.client.at(uri, "  Wheel(Siz", "definition")
        self.assertEqual(place["uri"], uri_of(self.folder / "parts.inc"))
        self.assertEqual(place["range"]["start"], {"line": 1, "character": 9})
        self.assertEqual(self.client.at(uri, '#include "par', "definition")["uri"], uri_of(self.folder / "parts.inc"))

    def test_references(self):
        uri = self.open()
        self.assertEqual(len(self.client.at(uri, "#macro Whe", "references", context={"includeDeclaration": True})), 3)
        self.assertEqual(len(self.client.at(uri, "#macro Whe", "references", context={"includeDeclaration": False})), 2)

    def test_rename_in_all_files(self):
        uri = self.open()
        changes = self.client.at(uri, "  Wheel(Siz", "rename", newName="Length")["changes"]
        self.assertEqual(apply_edits(SCENE, changes[uri]), SCENE.replace("Size", "Length"))
        self.assertEqual(apply_edits(PARTS, changes[uri_of(self.folder / "parts.inc")]), PARTS.replace("Size", "Length"))

    def test_a_local_name_is_renamed_alone(self):
        text = SCENE + "#declare Thin = 3;\nsphere { 0, Thin }\n"
        uri = self.open(text)
        changes = self.client.at(uri, "#local Thi", "rename", newName="Narrow")["changes"]
        self.assertEqual(apply_edits(text, changes[uri]),
                         text.replace("#local Thin", "#local Narrow").replace("Radius, Thin", "Radius, Narrow"))

    def test_names_that_cannot_be_are_refused(self):
        uri = self.open()
        for name in ("sphere", "2fast", "a b", "", "Red"):
            with self.assertRaises(RuntimeError):
                self.client.at(uri, "  Wheel(Siz", "rename", newName=name)

    def test_outline_and_folds(self):
        uri = self.open()
        symbols = self.client.of(uri, "documentSymbol")
        self.assertEqual([s["name"] for s in symbols],
                         ["global_settings", "parts.inc", "Wheel", "Red", "camera", "light_source", "union"])
        self.assertEqual([s["name"] for s in symbols[2]["children"]], ["Thin", "torus"])
        folds = [(f["startLine"], f["endLine"]) for f in self.client.of(uri, "foldingRange")]
        self.assertIn((12, 15), folds)
        self.assertIn((5, 7), folds)


class Writing(Session):
    def test_colours(self):
        uri = self.open(SCENE.replace("{ Red }", "{ srgb <0.5, 0.25, 1> }").replace("<1, 0, 0>", "<0.2140, 0, 0>"))
        colors = self.client.of(uri, "documentColor")
        self.assertAlmostEqual(colors[0]["color"]["red"], 0.5, 2)  # light 0.214 is shown as 0.5
        self.assertEqual(colors[-1]["color"], {"red": 0.5, "green": 0.25, "blue": 1.0, "alpha": 1.0})
        offered = self.client.of(uri, "colorPresentation", color={"red": 0.5, "green": 0, "blue": 1, "alpha": 0.25},
                                 range=colors[0]["range"])
        self.assertEqual([o["label"] for o in offered], ["rgbt <0.214, 0, 1, 0.75>", "srgbt <0.5, 0, 1, 0.75>"])

    def test_corrections(self):
        uri = self.open(SCENE.replace("union {", "Union {"))
        self.assertEqual(self.client.diagnostics[uri][0]["range"]["start"], {"line": 12, "character": 0})
        actions = self.client.of(uri, "codeAction", context={"diagnostics": []},
                                 range=self.client.diagnostics[uri][0]["range"])
        edits = actions[0]["edit"]["changes"][uri]
        self.assertEqual(apply_edits(self.client.texts[uri][1], edits), SCENE)

    def test_formatting(self):
        ugly = ("#declare A=\n texture{pigment{rgb 1}}   \nunion{\nsphere{0,1}\n   box{0,1\n texture{A}\n}\n"
                "#if(1)\nscale 2\n#else\n scale 3\n#end\n}\n")
        wanted = ("#declare A=\n  texture {pigment {rgb 1}}\nunion {\n  sphere {0,1}\n  box {0,1\n    texture {A}\n  }\n"
                  "  #if(1)\n    scale 2\n  #else\n    scale 3\n  #end\n}\n")
        uri = self.open(ugly)
        options = {"tabSize": 2, "insertSpaces": True}
        once = apply_edits(ugly, self.client.of(uri, "formatting", options=options))
        self.assertEqual(once, wanted)
        self.client.write(uri, once)
        self.assertEqual(self.client.of(uri, "formatting", options=options), [])

    def test_every_scene_keeps_its_tokens_and_is_formatted_once(self):
        def words(text):
            return "".join(text.split())  # only blanks may change
        options = {"tabSize": 2, "insertSpaces": True}
        for path in sorted(SCENES.rglob("*.pov")):
            text = path.read_bytes().decode("utf-8", "replace")
            uri = self.client.open(path, text)
            once = apply_edits(text, self.client.of(uri, "formatting", options=options))
            self.assertEqual(words(once), words(text), path)
            self.client.write(uri, once)
            self.assertEqual(self.client.of(uri, "formatting", options=options), [], path)
            self.client.close(uri)

    def test_render_and_explain(self):
        uri = self.open()
        result = self.client.ask("workspace/executeCommand", {"command": "verisim.render", "arguments": [
            {"uri": uri, "width": 40, "height": 30, "antialias": False}]}, timeout=120)
        self.assertEqual(result["status"], 0, result)
        self.assertTrue(pathlib.Path(result["picture"]).read_bytes().startswith(b"\x89PNG"))
        said = self.client.ask("workspace/executeCommand", {"command": "verisim.explain", "arguments": [
            {"uri": uri, "position": {"line": 15, "character": 4}}]})
        self.assertIn("union (", said["text"])
        self.assertIn("It has 2 parts.", said["text"])
        self.assertIn("opened", self.client.ask("workspace/executeCommand", {
            "command": "verisim.explainCode", "arguments": ["unclosed-block"]})["text"].lower() + "opened")


class Grammar(unittest.TestCase):
    def test_of_the_extension_is_the_program_s(self):
        """npm run grammar, in editors/vscode, writes it anew."""
        wanted = subprocess.run([VERISIM, "help", "--format", "grammar"], capture_output=True, check=True).stdout
        self.assertEqual((SCENES.parent / "editors/vscode/syntaxes/pov.tmLanguage.json").read_bytes(), wanted)


class Protocol(Session):
    def test_bad_requests_are_answered(self):
        self.assertEqual(self.client.ask_raw("no/such", {})["error"]["code"], -32601)
        self.assertEqual(self.client.ask_raw("textDocument/hover", {})["error"]["code"], -32602)
        self.assertEqual(self.client.ask_raw("textDocument/hover", {
            "textDocument": {"uri": "file:///nowhere.pov"}, "position": {"line": 0, "character": 0}})["error"]["code"], -32602)

    def test_places_outside_of_the_text_are_taken(self):
        uri = self.open()
        for line, column in ((10**6, 0), (0, 10**6), (3, 10**9)):
            self.client.ask("textDocument/hover", {"textDocument": {"uri": uri},
                                                   "position": {"line": line, "character": column}})

    def test_random_edits_end_where_the_text_does(self):
        """Many small edits, each a part of a scene put somewhere else; the last state is that of check."""
        random.seed(7)
        scenes = sorted(SCENES.rglob("*.pov"), key=lambda p: p.stat().st_size)[:40]
        for path in random.sample(scenes, 12):
            text = path.read_bytes().decode("utf-8", "replace")
            uri = self.client.open(path, text)
            for _ in range(25):
                now = self.client.texts[uri][1]
                begin = random.randrange(len(now) + 1)
                end = min(len(now), begin + random.choice((0, 0, 1, 3, 20)))
                source = random.randrange(len(text))
                self.client.edit(uri, begin, end, text[source:source + random.choice((0, 1, 2, 8, 30))])
                if random.random() < 0.3:
                    place = Client.position(self.client.texts[uri][1], min(begin, len(self.client.texts[uri][1])))
                    method = random.choice(("hover", "completion", "signatureHelp", "definition", "prepareRename"))
                    self.client.ask_raw("textDocument/" + method, {"textDocument": {"uri": uri}, "position": place})
                if random.random() < 0.1:
                    for method in ("documentSymbol", "foldingRange", "documentColor", "documentLink"):
                        self.client.of(uri, method)
            self.client.write(uri, text)  # as it was: what is left must be what the file has
            again = self.client.wait_for_diagnostics(uri)
            self.client.close(uri)
            fresh = self.client.open(path, text)
            mistakes = [[d for d in all_ if d["severity"] < 4] for all_ in (self.client.wait_for_diagnostics(fresh), again)]
            self.assertEqual(*mistakes, path)
            self.client.close(fresh)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
