// The page of `verisim view` in a tab. Its server answers nobody but this machine and refuses to be framed by other
// pages, so the tab asks through the extension: the page's `fetch` becomes a message.
import { ChildProcess, spawn } from 'child_process';
import { randomBytes } from 'crypto';
import * as path from 'path';

export interface PageRequest { id: number; url: string; method?: string; body?: string }
export interface PageReply { id: number; status: number; type: string; body: Uint8Array }

// Runs in the tab before the page's own script.
const relay = `
const asVsCode = acquireVsCodeApi(), waiting = new Map();
let lastRequest = 0;
window.addEventListener('message', ({ data }) => {
  const done = waiting.get(data.id);
  waiting.delete(data.id);
  if (done) done(new Response(data.body.length ? new Uint8Array(data.body) : null,
    { status: data.status, headers: { 'Content-Type': data.type } }));
});
window.fetch = (url, options = {}) => new Promise((resolve) => {
  const id = ++lastRequest;
  waiting.set(id, resolve);
  asVsCode.postMessage({ id, url: String(url), method: options.method, body: options.body });
});
`;

export class LiveView {
  private process: ChildProcess | undefined;
  private address = '';

  constructor(private readonly program: string, private readonly scene: string) {}

  /** Starts the program; resolves when it serves. */
  async start(): Promise<void> {
    const child = spawn(this.program, ['view', this.scene, '--no-open'], { cwd: path.dirname(this.scene), stdio: ['ignore', 'pipe', 'pipe'] });
    this.process = child;
    let messages = '';
    child.stderr!.on('data', (bytes: Buffer) => { messages = (messages + bytes.toString()).slice(-4000); });
    this.address = await new Promise<string>((resolve, reject) => {
      let text = '';
      child.stdout!.on('data', (bytes: Buffer) => {
        text += bytes.toString();
        const found = /^http:\/\/127\.0\.0\.1:\d+\/\w+\//m.exec(text);
        if (found) resolve(found[0]);
      });
      child.on('error', reject);
      child.on('exit', (code) => reject(new Error(messages.trim() || `verisim view ended with status ${code}`)));
    });
  }

  stop(): void {
    this.process?.kill();
    this.process = undefined;
  }

  /** The page with its style and script inside, for a tab that may load nothing else. */
  async page(): Promise<string> {
    const text = async (name: string) => (await fetch(this.address + name)).text();
    const [html, style, script] = await Promise.all([text(''), text('view.css'), text('view.js')]);
    const nonce = randomBytes(16).toString('hex');
    const policy = `default-src 'none'; img-src data: blob:; style-src 'nonce-${nonce}'; script-src 'nonce-${nonce}'`;
    return html
      .replace(/<head>/i, () => `<head><meta http-equiv="Content-Security-Policy" content="${policy}">`)
      .replace(/<link[^>]*view\.css[^>]*>/i, () => `<style nonce="${nonce}">${style}</style>`)
      .replace(/<script[^>]*view\.js[^>]*><\/script>/i,
        (tag) => `<script nonce="${nonce}">${relay}</script><script nonce="${nonce}"${/type="module"|defer/.test(tag) ? ' type="module"' : ''}>${script}</script>`);
  }

  /** Asks the server for the page. Only paths below its address are asked. */
  async answer(request: PageRequest): Promise<PageReply> {
    const target = new URL(request.url, this.address);
    if (!target.href.startsWith(this.address)) return { id: request.id, status: 403, type: 'text/plain', body: new Uint8Array() };
    try {
      const reply = await fetch(target, { method: request.method ?? 'GET', body: request.body });
      return { id: request.id, status: reply.status, type: reply.headers.get('Content-Type') ?? '', body: new Uint8Array(await reply.arrayBuffer()) };
    } catch (error) {
      return { id: request.id, status: 503, type: 'text/plain', body: new TextEncoder().encode(String(error)) };
    }
  }
}
