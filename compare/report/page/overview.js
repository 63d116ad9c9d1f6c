// The table of all scenes. Only the rows that are seen exist, all of one height, so that thousands of scenes cost no
// more than a few.
const UNIT = scenes.some(s => s.cpu) ? 'CPU s' : 's';
const figure = key => s => s.metrics ? s.metrics[key] : null;
const COLUMNS = [
  { key: 'name', label: 'Scene', get: s => s.name.toLowerCase(), left: true },
  { key: 'status', label: 'Status', get: s => ORDER.indexOf(s.status), left: true },
  { key: 'rmse', label: 'RMSE', get: figure('rmse'), digits: 3, down: true },
  { key: 'psnr', label: 'PSNR', get: figure('psnr'), digits: 1, far: true },
  { key: 'ssim', label: 'SSIM', get: figure('ssim_mean'), digits: 4 },
  { key: 'flip', label: 'FLIP', get: figure('flip_mean'), digits: 4, down: true },
  { key: 'within', label: 'Within 1 %', get: figure('within_1_pct'), digits: 3 },
  { key: 'max', label: 'Max', get: figure('max_abs'), digits: 0, down: true },
  { key: 'oracle', label: UNIT, title: `${WHO.o}: ${UNIT === 's' ? 'seconds' : 'seconds of user and system time'}`, get: s => s.oracle_seconds || null, digits: 2, down: true, far: true },
  { key: 'native', label: UNIT, title: `${WHO.n}: ${UNIT === 's' ? 'seconds' : 'seconds of user and system time'}`, get: s => s.native_seconds || null, digits: 2, down: true, far: true },
  { key: 'ratio', label: 'Ratio', get: ratio, digits: 1, suffix: '×', far: true },
].filter(c => ['name', 'status'].includes(c.key) || scenes.some(s => { const v = c.get(s); return v !== null && v !== undefined; }));
const phone = matchMedia('(max-width: 760px)');
const rowHeight = () => phone.matches ? 186 : 84;
const view = { sort: 'status', reverse: false, text: '', statuses: new Set(), order: [], at: 0, first: -1, last: -1 };

const summary = s => [(s.why || s.reason).replace(/\.$/, ''), s.known_answer, s.verisimilitude, s.suspects.length && `suspect: ${s.suspects[0].what}`, s.blame && s.blame.common.length && `in common: ${s.blame.common[0].name}`]
  .filter(Boolean).join('; ');
const changed = s => {
  if (s.previous && s.previous !== s.status) return `was ${nameOf(s.previous)}`;
  if (s.metrics && s.previous_rmse !== null && Math.abs(s.metrics.rmse - s.previous_rmse) > 0.005) return `RMSE was ${fixed(s.previous_rmse, 3)}`;
  return '';
};
function thumbnail(i, side, what) {
  const s = scenes[i], key = has(i, 't' + side) ? 't' + side : side;
  if (side === 'd' && !has(i, 'td')) return node('span', { className: 'none', title: s.metrics ? 'no difference' : 'nothing was compared' }, s.metrics ? '=' : '');
  if (!has(i, key)) return node('span', { className: 'none', title: `no picture: ${what}` });
  const image = node('img', { alt: side === 'd' ? `difference of ${s.name}` : `${what}: ${s.name}`, title: what });
  const address = source(i, key);
  if (address) image.src = address; else whenRead(i, key).then(later => { if (later) image.src = later; });
  return image;
}
function rowOf(i, at) {
  const s = scenes[i], link = node('a', { href: `#${i}`, title: s.name }, s.name), note = summary(s);
  const status = node('td', { className: 'l status' }, node('span', { className: 'st ' + s.status }, `${ICON[s.status]} ${nameOf(s.status)}`));
  if (decisionOf(s)) status.append(node('span', { className: 'was' }, decisionOf(s).decision));
  else if (changed(s)) status.append(node('span', { className: 'was' }, changed(s)));
  const tr = node('tr', { className: 'scene-row' }, node('td', { className: 'pics' }, thumbnail(i, 'o', WHO.o), thumbnail(i, 'n', WHO.n), thumbnail(i, 'd', 'difference')),
    node('td', { className: 'scene' }, link, node('small', { title: note }, note), trend(s)), status);
  tr.dataset.scene = i; tr.setAttribute('aria-rowindex', at + 2);
  for (const c of COLUMNS.slice(2)) {
    const v = c.get(s), td = node('td', { className: 'num' + (c.far ? ' far' : '') }, v === null || v === undefined ? '–' : fixed(v, c.digits) + (c.suffix || ''));
    td.dataset.label = c.label.replace(' %', ''); tr.append(td);
  }
  tr.onclick = e => { if (e.target !== link) location.hash = i; };
  return tr;
}
// The course of the RMSE over earlier runs, as a line.
function trend(s) {
  const runs = [...(s.history || []).map(h => h.rmse), s.metrics ? s.metrics.rmse : null].filter(v => v !== null && v !== undefined);
  if (runs.length < 2) return '';
  const ns = 'http://www.w3.org/2000/svg', svg = document.createElementNS(ns, 'svg'), line = document.createElementNS(ns, 'polyline'), title = document.createElementNS(ns, 'title');
  const top = Math.max(...runs, 1e-9);
  line.setAttribute('points', runs.map((v, k) => `${(2 + 56 * k / (runs.length - 1)).toFixed(1)},${(14 - 12 * v / top).toFixed(1)}`).join(' '));
  title.textContent = `RMSE of ${runs.length} runs: ${runs.map(v => fixed(v, 3)).join(', ')}`;
  svg.setAttribute('viewBox', '0 0 60 16'); svg.setAttribute('class', 'trend'); svg.append(title, line);
  return svg;
}

const spacer = rows => {
  const td = node('td'), tr = node('tr', { className: 'spacer' }, td);
  td.style.height = tr.style.height = `${rows * rowHeight()}px`;
  tr.setAttribute('aria-hidden', 'true');
  return tr;
};
function paintRows(anew) {
  if ($('overview').hidden) return;
  const above = $('rows').getBoundingClientRect().top, height = rowHeight(), most = view.order.length;
  const first = clamp(Math.floor(-above / height) - 6, 0, Math.max(0, most - 1)), last = clamp(Math.ceil((innerHeight - above) / height) + 6, 0, most);
  if (!anew && first === view.first && last === view.last) return;
  view.first = first; view.last = last;
  const kept = new Map(anew ? [] : [...$('rows').children].filter(tr => tr.dataset.scene).map(tr => [+tr.dataset.scene, tr]));
  const rows = view.order.slice(first, last).map((i, k) => kept.get(i) || rowOf(i, first + k));
  const focused = document.activeElement;
  $('rows').replaceChildren(...(first ? [spacer(first)] : []), ...rows, ...(last < most ? [spacer(most - last)] : []));
  if (focused && focused.isConnected && focused !== document.activeElement) focused.focus({ preventScroll: true });
}
function focusRow(at) {
  view.at = clamp(at, 0, view.order.length - 1);
  const top = $('rows').getBoundingClientRect().top + scrollY + view.at * rowHeight(), head = 60;
  if (top - head < scrollY) scrollTo(0, top - head);
  else if (top + rowHeight() > scrollY + innerHeight) scrollTo(0, top + rowHeight() - innerHeight + 8);
  paintRows();
  const row = [...$('rows').children].find(tr => tr.dataset.scene === String(view.order[view.at]));
  if (row) row.querySelector('a').focus({ preventScroll: true });
}
addEventListener('scroll', () => paintRows(), { passive: true });
addEventListener('resize', () => paintRows());
phone.addEventListener('change', () => paintRows(true));

const heads = COLUMNS.map(c => {
  const th = node('th', { scope: 'col', className: (c.left ? 'l' : '') + (c.far ? ' far' : ''), title: c.title || '' }, node('button', { type: 'button', onclick: () => sortBy(c.key) }, c.label));
  th.dataset.key = c.key;
  return th;
});
$('heads').append(node('th', { scope: 'col', className: 'l pics' }, node('span', { title: WHO.o }, WHO.o), node('span', { title: WHO.n }, WHO.n), node('span', {}, 'difference')), ...heads);
$('sort').append(...COLUMNS.map(c => node('option', { value: c.key }, c.title ? `${c.title}` : c.label)));
$('sort').onchange = e => sortBy(e.target.value);

function sortBy(key) {
  view.reverse = view.sort === key ? !view.reverse : !!COLUMNS.find(c => c.key === key).down;
  view.sort = key;
  show();
}
const words = s => `${s.name} ${s.status} ${s.class} ${s.reason} ${s.tags.join(' ')} ${s.features.join(' ')} ${s.suspects.map(v => v.what).join(' ')} ${s.blame ? s.blame.common.map(c => c.name).join(' ') : ''}`.toLowerCase();
function matches(s) {
  if (view.statuses.size && !view.statuses.has(s.status)) return false;
  if (!view.text) return true;
  const all = words(s);
  return view.text.toLowerCase().split(/\s+/).every(word => all.includes(word));
}
function show() {
  const get = COLUMNS.find(c => c.key === view.sort).get, worst = figure('rmse');
  const compare = (a, b) => {
    const x = get(scenes[a]), y = get(scenes[b]), none = v => v === null || v === undefined;
    if (none(x) || none(y)) return none(x) - none(y) || a - b;  // nothing to say: last in either direction
    const d = (x < y ? -1 : x > y ? 1 : 0) * (view.reverse ? -1 : 1);
    return d || (worst(scenes[b]) || 0) - (worst(scenes[a]) || 0) || a - b;
  };
  view.order = scenes.map((s, i) => i).filter(i => matches(scenes[i])).sort(compare);
  for (const th of heads) {
    if (th.dataset.key === view.sort) th.setAttribute('aria-sort', view.reverse ? 'descending' : 'ascending'); else th.removeAttribute('aria-sort');
  }
  $('sort').value = view.sort;
  $('shown').textContent = view.order.length === scenes.length ? '' : `${view.order.length} of ${scenes.length} scenes`;
  $('scenes').setAttribute('aria-rowcount', view.order.length + 1);
  paintRows(true);
}
function headline() {
  const bad = scenes.filter(s => !passed(s)).length;
  $('verdict').textContent = bad ? `✗ ${bad} of ${scenes.length} ${scenes.length === 1 ? 'scene' : 'scenes'} not the same` : `✓ ${scenes.length} ${scenes.length === 1 ? 'scene' : 'scenes'} the same`;
  $('verdict').className = 'st ' + (bad ? 'differ' : 'exact');
  $('about').textContent = [data.started.replace('T', ' ').replace('Z', ' UTC'), data.oracle_version && `against POV-Ray ${data.oracle_version}`, data.native_version && WHO.n + ' ' + (data.native_version.length > 60 ? data.native_version.slice(0, 60) + '…' : data.native_version),
    data.cancelled && 'broken off'].filter(Boolean).join(' · ');
  $('answers').textContent = data.known_answers; $('answers').hidden = !data.known_answers;
  $('chips').replaceChildren(...ORDER.slice().reverse().map(status => [status, scenes.filter(s => s.status === status).length]).filter(([, count]) => count).map(([status, count]) => {
    const chip = node('button', { type: 'button', onclick: () => {
      if (!view.statuses.delete(status)) view.statuses.add(status);
      chip.setAttribute('aria-pressed', view.statuses.has(status));
      show();
    } }, `${ICON[status]} ${count} ${nameOf(status)}`);
    chip.setAttribute('aria-pressed', 'false'); chip.dataset.status = status;
    return chip;
  }));
}
let typing = 0;
$('filter').oninput = e => { clearTimeout(typing); typing = setTimeout(() => { view.text = e.target.value.trim(); show(); }, scenes.length > 1000 ? 150 : 0); };
