// What all parts of the page share: the data, the pictures' addresses, names of statuses, small helpers.
const $ = id => document.getElementById(id);
const data = JSON.parse($('data').textContent);
const scenes = data.scenes;
const WHO = { ...data.names };  // who made the two pictures: { o, n }
const node = (tag, props = {}, ...children) => { const e = Object.assign(document.createElement(tag), props); e.append(...children); return e; };
const store = {
  get(key) { try { return localStorage.getItem(key); } catch { return null; } },
  set(key, value) { try { localStorage.setItem(key, value); } catch { /* a file may have no storage */ } },
};
const ICON = { exact: '✓', match: '≈', differ: '✗', unsupported: '∅', error: '!', oracle_failed: '?', new: '+', removed: '−' };
const ORDER = ['error', 'differ', 'oracle_failed', 'removed', 'new', 'unsupported', 'match', 'exact'];  // what to look at first
const nameOf = status => status === 'oracle_failed' ? 'oracle failed' : status;
const passed = s => s.status === 'exact' || s.status === 'match';
const fixed = (v, n) => v === null || v === undefined || !isFinite(v) ? '–' : v.toFixed(n);
const ratio = s => s.oracle_seconds > 0 && s.native_seconds > 0 ? s.oracle_seconds / s.native_seconds : null;
const clamp = (v, low, high) => Math.min(Math.max(v, low), high);

// ---- pictures: served one by one, or base64 text in inert script elements, which come after this script ----
const has = (i, key) => scenes[i].pictures.includes(key);
const pictureId = (i, key) => `p${i}${scenes[i].same && key.endsWith('n') ? key.slice(0, -1) + 'o' : key}`;
function source(i, key) {  // null: not there, or not read yet
  if (!has(i, key)) return null;
  const id = pictureId(i, key);
  if (data.served) return `picture?id=${id}`;
  const text = $(id);
  return text ? 'data:image/png;base64,' + text.textContent : null;
}
const allRead = new Promise(done => { if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', done); else done(); });
async function whenRead(i, key) {
  if (!source(i, key)) await allRead;
  return source(i, key);
}
async function decode(i, key) {  // { canvas, pixels, width, height }, or null
  if (!has(i, key)) return null;
  const image = new Image();
  image.src = await whenRead(i, key);
  await image.decode();
  const canvas = node('canvas', { width: image.naturalWidth, height: image.naturalHeight }), g = canvas.getContext('2d', { willReadFrequently: true });
  g.drawImage(image, 0, 0);
  return { canvas, pixels: g.getImageData(0, 0, canvas.width, canvas.height).data, width: canvas.width, height: canvas.height };
}

// ---- light and dark ----
const setTheme = theme => { if (theme) document.documentElement.dataset.theme = theme; else delete document.documentElement.dataset.theme; };
setTheme(store.get('verisim-theme'));
$('theme').onclick = () => {
  const chosen = document.documentElement.dataset.theme;
  const dark = chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  setTheme(dark ? 'light' : 'dark');
  store.set('verisim-theme', dark ? 'light' : 'dark');
};
for (const side of ['o', 'n']) for (const e of document.querySelectorAll('.who-' + side)) e.textContent = WHO[side];
