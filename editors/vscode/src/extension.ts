// The extension: starts `verisim lsp`, and shows what its commands give.
import * as path from 'path';
import * as vscode from 'vscode';
import { LanguageClient, LanguageClientOptions, ServerOptions } from 'vscode-languageclient/node';
import { LiveView } from './live';

let client: LanguageClient | undefined;

const settings = () => vscode.workspace.getConfiguration('verisim');
const program = () => settings().get<string>('path', 'verisim');

async function start(): Promise<void> {
  const lints = settings().get<string[]>('lints', ['all']).flatMap((name) => ['--lint', name]);
  const server: ServerOptions = { command: program(), args: ['lsp', ...lints, ...settings().get<string[]>('arguments', [])] };
  const options: LanguageClientOptions = {
    documentSelector: [{ scheme: 'file', language: 'pov' }, { scheme: 'untitled', language: 'pov' }],
    synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher('**/*.{inc,pov,mcr}') },
  };
  client = new LanguageClient('verisim', 'verisim', server, options);
  try {
    await client.start();
  } catch (error) {
    vscode.window.showErrorMessage(`verisim cannot be started: ${error}. The setting "verisim.path" names the program.`);
  }
}

/** What a command of the server gives; its complaint is shown. */
async function ask<T>(command: string, argument: unknown, title: string): Promise<T | undefined> {
  if (!client) return undefined;
  try {
    return await vscode.window.withProgress({ location: vscode.ProgressLocation.Notification, title }, () =>
      client!.sendRequest<T>('workspace/executeCommand', { command, arguments: [argument] }));
  } catch (error) {
    vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
    return undefined;
  }
}

async function render(output: vscode.OutputChannel): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (!editor) return;
  const result = await ask<{ status: number; messages: string; picture?: string }>('verisim.render', {
    uri: editor.document.uri.toString(), width: settings().get('renderWidth', 640), height: settings().get('renderHeight', 480),
  }, 'Rendering');
  if (!result) return;
  output.append(result.messages);
  if (result.picture) await vscode.commands.executeCommand('vscode.open', vscode.Uri.file(result.picture), vscode.ViewColumn.Beside);
  else output.show();
}

async function explain(output: vscode.OutputChannel): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (!editor) return;
  const { line, character } = editor.selection.active;
  const result = await ask<{ text: string; object: unknown }>('verisim.explain',
    { uri: editor.document.uri.toString(), position: { line, character } }, 'Reading the scene');
  if (!result) return;
  output.appendLine(result.text);
  output.appendLine(JSON.stringify(result.object, null, 1));
  output.show(true);
}

async function live(context: vscode.ExtensionContext): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (!editor || editor.document.isUntitled) {
    vscode.window.showInformationMessage('The live picture follows a saved scene.');
    return;
  }
  const file = editor.document.uri.fsPath;
  const view = new LiveView(program(), file);
  try {
    await view.start();
    const panel = vscode.window.createWebviewPanel('verisim.live', path.basename(file), vscode.ViewColumn.Beside,
      { enableScripts: true, retainContextWhenHidden: true });
    panel.onDidDispose(() => view.stop());
    panel.webview.onDidReceiveMessage(async (request) => panel.webview.postMessage(await view.answer(request)));
    panel.webview.html = await view.page();
    context.subscriptions.push({ dispose: () => view.stop() });
  } catch (error) {
    view.stop();
    vscode.window.showErrorMessage(`The live picture cannot be shown: ${error instanceof Error ? error.message : error}`);
  }
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const output = vscode.window.createOutputChannel('verisim renders');
  context.subscriptions.push(
    output,
    vscode.commands.registerCommand('verisim.showRender', () => render(output)),
    vscode.commands.registerCommand('verisim.explainObject', () => explain(output)),
    vscode.commands.registerCommand('verisim.liveView', () => live(context)),
    vscode.commands.registerCommand('verisim.restart', async () => { await client?.stop(); await start(); }));
  await start();
}

export async function deactivate(): Promise<void> { await client?.stop(); }
