// One scene, opened at the place that is worst; the way between scenes; keys.
async function open(i) {
  const s = scenes[i], fresh = eye.index !== i;
  eye.index = i;
  $('overview').hidden = true; $('detail').hidden = false;
  document.title = `${s.name} – verisim report`;
  if (!fresh) return;
  $('name').textContent = s.name; $('name').title = s.name;
  $('status').className = 'st ' + s.status; $('status').textContent = `${ICON[s.status]} ${nameOf(s.status)}`;
  $('reason').textContent = s.why || s.reason;
  WHO.o = s.reference || data.names.o;  // a photograph is not POV-Ray's
  figures(s); histogram(s); worst(s); blame(s); truth(s); suspects(s); reviewState(s);
  $('explain').hidden = $('tree').hidden = $('flip').hidden = true;
  $('place').hidden = !s.place || passed(s);
  for (const option of $('map').options) option.hidden = !!MAPS[option.value].stored && !has(i, MAPS[option.value].stored);
  if ($('map').selectedOptions[0].hidden) $('map').value = 'difference';
  $('scale-row').hidden = !MAPS[$('map').value].scaled;
  $('expose').hidden = s.fine !== 'half';
  Object.assign(eye, { cursor: null, overlay: null, map: null, o: null, n: null, oa: null, na: null });
  draw();
  const [o, n, oa, na, of, nf] = await Promise.all(['o', 'n', 'oa', 'na', 'of', 'nf'].map(key => (key[1] === 'f' ? fineValues : decode)(i, key).catch(() => null)));
  if (eye.index !== i) return;
  if (o && of) o.fine = of;
  if (n && nf) n.fine = nf;
  Object.assign(eye, { o, n, oa, na, width: (o || n || s).width, height: (o || n || s).height });
  document.querySelector('.readout').classList.toggle('with-alpha', !!(oa || na));
  canvas.setAttribute('aria-label', `${s.name}: the pictures of ${WHO.o} and ${WHO.n}, ${eye.width} by ${eye.height} pixels`);
  await makeMap();
  if (eye.index !== i) return;
  const failed = !passed(s);
  setMode(o && n ? (failed ? 'all' : eye.mode) : n ? 'native' : 'oracle');
  if (failed && s.place && o && n) fitTo(s.place); else fit();
  if (has(i, 'flip')) decode(i, 'flip').then(map => { if (eye.index === i && map) flipHistogram(Float32Array.from({ length: map.width * map.height }, (_, at) => map.pixels[4 * at] / 255)); }).catch(() => {});
  canvas.dataset.ready = i;
}
let lastScroll = 0;
function close() {
  clearInterval(eye.timer);
  const i = eye.index;
  eye.index = -1;
  $('detail').hidden = true; $('overview').hidden = false; document.title = 'verisim report';
  scrollTo(0, lastScroll); paintRows(true);
  const at = view.order.indexOf(i);
  if (at >= 0) focusRow(at);
}
function route() {
  const i = parseInt(location.hash.slice(1), 10);
  if (i >= 0 && i < scenes.length) {
    if (!$('overview').hidden) lastScroll = scrollY;
    open(i); scrollTo(0, 0);
  } else if (!$('detail').hidden) close();
}
const neighbour = d => { const i = view.order[view.order.indexOf(eye.index) + d]; if (i !== undefined) location.replace('#' + i); };
$('back').onclick = () => { location.hash = ''; }; $('previous').onclick = () => neighbour(-1); $('next').onclick = () => neighbour(1);
addEventListener('hashchange', route);
const OVERVIEW_KEYS = { ArrowDown: 1, j: 1, ArrowUp: -1, k: -1 };
const SCENE_KEYS = {
  j: () => neighbour(1), k: () => neighbour(-1), '+': () => zoomAt(2), '=': () => zoomAt(2), '-': () => zoomAt(0.5), 0: fit,
  w: () => { if (!$('place').hidden) $('place').onclick(); },
  m: () => { const shown = [...$('map').options].filter(o => !o.hidden), at = shown.findIndex(o => o.selected); $('map').value = shown[(at + 1) % shown.length].value; $('map').onchange(); },
  a: () => decide('accepted'), r: () => decide('refused'), u: () => decide('open'),
};
addEventListener('keydown', e => {
  if (e.ctrlKey || e.metaKey || e.altKey) return;
  const field = /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName) && e.target.type !== 'range';
  if (e.key === 'Escape') { if (field) e.target.blur(); else if (!$('detail').hidden) location.hash = ''; return; }
  if (field) return;
  if ($('detail').hidden) {
    if (e.key === '/') { e.preventDefault(); $('filter').focus(); }
    const d = OVERVIEW_KEYS[e.key];
    if (!d || !view.order.length) return;
    e.preventDefault();
    const row = document.activeElement.closest && document.activeElement.closest('.scene-row');
    focusRow(row ? view.order.indexOf(+row.dataset.scene) + d : 0);
    return;
  }
  const mode = MODES.find(m => m[2] === e.key.toLowerCase());
  if (mode) setMode(mode[0]);
  else if (SCENE_KEYS[e.key]) SCENE_KEYS[e.key]();
});
headline(); reviewBar(); show(); route();
