// The grammar over scenes: it is read by the engine of VS Code, and every word of the language gets a colour.
import assert from 'node:assert';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import * as oniguruma from 'vscode-oniguruma';
import { IGrammar, INITIAL, parseRawGrammar, Registry } from 'vscode-textmate';

const root = join(__dirname, '..', '..'), repository = join(root, '..', '..');
const folders = [join(repository, 'scenes'), '/usr/share/doc/povray/examples'];
let grammar: IGrammar;

before(async () => {
  const wasm = readFileSync(join(root, 'node_modules/vscode-oniguruma/release/onig.wasm'));
  await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
  const file = join(root, 'syntaxes/pov.tmLanguage.json');
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns), createOnigString: (s) => new oniguruma.OnigString(s),
    }),
    loadGrammar: async () => parseRawGrammar(readFileSync(file, 'utf8'), file),
  });
  grammar = (await registry.loadGrammar('source.pov'))!;
});

/** The scopes of each piece of a text, as [piece, innermost scope]. */
function colored(text: string): [string, string][] {
  const pieces: [string, string][] = [];
  let state = INITIAL;
  for (const line of text.split(/\r\n|\r|\n/)) {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, state);
    for (const t of tokens) pieces.push([line.slice(t.startIndex, t.endIndex), t.scopes[t.scopes.length - 1]]);
    state = ruleStack;
  }
  return pieces;
}

test('pieces of a scene', () => {
  const scope = new Map(colored('#declare Red = rgb <1, 0.5, .25>; // note\nsphere { 0, sin(1) texture { Red } }\n/* a /* b */ c */ box'));
  assert.strictEqual(scope.get('#declare'), 'keyword.control.directive.pov');
  assert.strictEqual(scope.get('rgb'), 'support.constant.color.pov');
  assert.strictEqual(scope.get('0.5'), 'constant.numeric.pov');
  assert.strictEqual(scope.get('// note'), 'comment.line.double-slash.pov');
  assert.strictEqual(scope.get('sphere'), 'storage.type.object.pov');
  assert.strictEqual(scope.get('sin'), 'support.function.pov');
  assert.strictEqual(scope.get(' c '), 'comment.block.pov');
  assert.strictEqual(scope.get('box'), 'storage.type.object.pov');
});

function* scenes(folder: string): Generator<string> {
  let entries;
  try { entries = readdirSync(folder, { withFileTypes: true }); } catch { return; }
  for (const entry of entries) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) yield* scenes(path);
    else if (/\.(pov|inc)$/i.test(entry.name)) yield path;
  }
}

test('words keep their colour in every scene, and no comment or string runs on', () => {
  let count = 0;
  for (const folder of folders) for (const file of scenes(folder)) {
    const text = readFileSync(file, 'latin1');
    if (text.length > 300000) continue;
    ++count;
    let state = INITIAL;
    for (const line of text.split(/\r\n|\r|\n/)) {
      const { tokens, ruleStack } = grammar.tokenizeLine(line.slice(0, 2000), state);
      for (const t of tokens) {
        const piece = line.slice(t.startIndex, t.endIndex), inner = t.scopes[t.scopes.length - 1];
        if (piece === 'sphere') assert.match(inner, /object|comment|string/, file);
      }
      state = ruleStack;
    }
    const end = grammar.tokenizeLine('sphere', state).tokens[0].scopes;
    assert.ok(end.some((s) => s.includes('object')), `${file} ends inside ${end}`);
  }
  assert.ok(count > 50, `${count} scenes`);
});
