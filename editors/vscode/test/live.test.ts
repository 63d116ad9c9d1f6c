// The live picture's page, and the way of its requests.
import assert from 'node:assert';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { LiveView } from '../src/live';

test('the page is whole and its requests are answered', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'verisim-'));
  const scene = join(folder, 'scene.pov');
  writeFileSync(scene, '#version 3.7; global_settings { assumed_gamma 1 } camera { location -5*z look_at 0 }\n' +
    'light_source { <3, 4, -9> rgb 1 } sphere { 0, 1 pigment { rgb 1 } }\n');
  const view = new LiveView(process.env.VERISIM ?? 'verisim', scene);
  try {
    await view.start();
    const page = await view.page();
    assert.match(page, /Content-Security-Policy/);
    assert.doesNotMatch(page, /src="view\.js"|href="view\.css"/);
    assert.match(page, /acquireVsCodeApi/);
    const update = await view.answer({ id: 7, url: 'update?generation=0&pieces=0&state=0' });
    assert.strictEqual(update.id, 7);
    assert.strictEqual(update.status, 200);
    assert.ok(update.body.length > 0);
    assert.strictEqual((await view.answer({ id: 8, url: 'http://127.0.0.1:1/elsewhere' })).status, 403);
  } finally {
    view.stop();
    rmSync(folder, { recursive: true });
  }
});

test('a program that is not there is told', async () => {
  await assert.rejects(new LiveView('/nowhere/verisim', '/nowhere/scene.pov').start(), /ENOENT/);
});
