// The server through the protocol library that vscode-languageclient is made of; VERISIM names the program.
import assert from 'node:assert';
import { ChildProcess, spawn } from 'node:child_process';
import { after, before, test } from 'node:test';
import {
  createProtocolConnection, Diagnostic, DidOpenTextDocumentNotification, Hover, HoverRequest, InitializeRequest, InitializedNotification,
  MarkupContent, ProtocolConnection, PublishDiagnosticsNotification, PublishDiagnosticsParams, StreamMessageReader,
  StreamMessageWriter,
} from 'vscode-languageserver-protocol/node';

const program = process.env.VERISIM ?? 'verisim';
const uri = 'untitled:scene.pov';
let server: ChildProcess, connection: ProtocolConnection;

before(async () => {
  server = spawn(program, ['lsp', '--delay', '10']);
  connection = createProtocolConnection(new StreamMessageReader(server.stdout!), new StreamMessageWriter(server.stdin!));
  connection.listen();
  await connection.sendRequest(InitializeRequest.type, { processId: process.pid, rootUri: null, capabilities: {} });
  await connection.sendNotification(InitializedNotification.type, {});
});
after(() => { connection.dispose(); server.kill(); });

test('diagnostics and hover', async () => {
  const published = new Promise<PublishDiagnosticsParams>((resolve) =>
    connection.onNotification(PublishDiagnosticsNotification.type, resolve));
  await connection.sendNotification(DidOpenTextDocumentNotification.type, {
    textDocument: { uri, languageId: 'pov', version: 1, text: '#version 3.7;\nsphere { 0, Raduis pigment { rgb 1 } }\n' },
  });
  const { diagnostics } = await published;
  const mistake = diagnostics.find((d) => d.code === 'undeclared-identifier');
  assert.deepStrictEqual(mistake?.range.start, { line: 1, character: 12 });
  const hover = await connection.sendRequest(HoverRequest.type, { textDocument: { uri }, position: { line: 1, character: 3 } }) as Hover;
  assert.match((hover.contents as MarkupContent).value, /sphere \{ CENTRE, RADIUS \}/);
});

test('lints are hints', async () => {
  const other = 'untitled:other.pov';
  const published = new Promise<Diagnostic>((resolve) =>
    connection.onNotification(PublishDiagnosticsNotification.type, ({ uri, diagnostics }) => {
      const hint = diagnostics.find((d) => uri === other && d.code === 'unused-name');
      if (hint) resolve(hint);
    }));
  await connection.sendNotification(DidOpenTextDocumentNotification.type, {
    textDocument: { uri: other, languageId: 'pov', version: 1, text: '#version 3.7;\n#declare Lonely = 1;\nsphere { 0, 1 }\n' },
  });
  const { severity, tags, range } = await published;
  assert.deepStrictEqual([severity, tags, range.start], [4, [1], { line: 1, character: 9 }]);
});
