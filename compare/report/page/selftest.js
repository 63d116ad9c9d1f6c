// Appended to a report by its test: uses the page as a reader would and writes what it saw into the document, one line a check.
(async () => {
  const out = document.createElement('pre'); out.id = 'selftest'; out.hidden = true; document.body.append(out);
  const $ = id => document.getElementById(id), wait = ms => new Promise(done => setTimeout(done, ms));
  // Pictures are decoded beside the page's clock, which timers run ahead of.
  const turn = () => new Promise(done => { const c = new MessageChannel(); c.port1.onmessage = done; c.port2.postMessage(0); });
  const check = (name, ok, seen) => { out.textContent += `${ok ? 'PASS' : 'FAIL'} ${name} [${seen}]\n`; };
  const key = (k, target = document.body) => target.dispatchEvent(new KeyboardEvent('keydown', { key: k, bubbles: true, cancelable: true }));
  const shown = () => { const text = $('shown').textContent; return text ? parseInt(text, 10) : count; };
  const names = () => [...document.querySelectorAll('#rows a')].map(a => a.textContent);
  window.onerror = message => check('no error', false, message);
  let count = 0;
  try {
    count = JSON.parse($('data').textContent).scenes.length; const open = performance.getEntriesByType('navigation')[0];
    out.textContent += `LOAD ${Math.round(open.loadEventEnd || performance.now())} ms\n`;
    check('only rows that are seen exist', names().length === Math.min(count, names().length) && names().length < 60 && +$('scenes').getAttribute('aria-rowcount') === count + 1, names().length);
    await wait(300);
    check('thumbnails that are seen are decoded', document.querySelector('#rows img').naturalWidth > 0, document.querySelector('#rows img').naturalWidth);
    check('the difference is in the row', [...document.querySelectorAll('#rows .scene-row')].some(r => r.querySelectorAll('img').length === 3), '');

    check('the overview says who is nearer to mathematics', !$('answers').hidden && $('answers').textContent.includes('verisim is nearer in'), $('answers').textContent);
    check('and so does the row', [...document.querySelectorAll('#rows small')].some(e => e.textContent.includes('off the known answer')), '');

    // Scrolling through everything: no frame may take long. Frames of headless Chromium follow the clock of the page.
    const work = []; let layout = 0, least = 1;
    for (let y = 0; y < document.documentElement.scrollHeight; y += 600) { const t = performance.now(); scrollTo(0, y); layout += document.documentElement.getBoundingClientRect().height; work.push(performance.now() - t); await wait(30); least = Math.min(least, names().length); }
    scrollTo(0, 0);
    check('rows are there wherever one scrolls', least > 0, least);
    check('scrolls without a stall', Math.max(...work) < 100 && layout > 0, `${work.length} steps, longest ${Math.max(...work).toFixed(1)} ms`);

    const head = k => document.querySelector(`#heads [data-key=${k}] button`);
    head('rmse').click();
    const figures = () => [...document.querySelectorAll('#rows td[data-label=RMSE]')].map(td => parseFloat(td.textContent)).filter(v => !isNaN(v));
    check('sorts falling', figures().every((v, i, a) => i === 0 || a[i - 1] >= v) && head('rmse').parentElement.getAttribute('aria-sort') === 'descending', figures().slice(0, 3));
    head('rmse').click();
    check('sorts rising', figures().every((v, i, a) => i === 0 || a[i - 1] <= v), figures().slice(0, 3));
    head('name').click();

    $('filter').value = 'differ'; $('filter').dispatchEvent(new Event('input')); await wait(250);
    check('filters by text', shown() > 0 && shown() < count && names().every(n => n.includes('shift')), names().length);
    $('filter').value = ''; $('filter').dispatchEvent(new Event('input')); await wait(250);
    const chip = document.querySelector('#chips [data-status=unsupported]'); chip.click();
    check('filters by status', names().length > 0 && names().every(n => n.includes('unsupported')), names().length);
    chip.click();
    check('shows all again', shown() === count, shown());
    $('filter').value = '<' + '/script>'; $('filter').dispatchEvent(new Event('input')); await wait(250);
    check('hostile names are text', !document.querySelector('#rows b') && names().length === 1 && names()[0].includes('<b>'), names()[0]);
    $('filter').value = 'shift'; $('filter').dispatchEvent(new Event('input')); await wait(250);

    const shift = [...document.querySelectorAll('#rows a')].find(a => a.textContent.includes('shift'));
    location.hash = shift.getAttribute('href'); await wait(500);
    const canvas = $('canvas');
    check('opens a scene', !$('detail').hidden && $('overview').hidden && canvas.dataset.ready === shift.getAttribute('href').slice(1), canvas.dataset.ready);
    const pixel = (x, y) => { const d = canvas.getContext('2d', { willReadFrequently: true }).getImageData(Math.round(x * devicePixelRatio), Math.round(y * devicePixelRatio), 1, 1).data; return `${d[0]},${d[1]},${d[2]}`; };
    const w = canvas.clientWidth, h = canvas.clientHeight, spot = [w / 2 - 40, h / 2 + 1], pressed = mode => $('modes').querySelector(`[data-mode=${mode}]`).getAttribute('aria-pressed') === 'true';
    check('a failing scene opens with both pictures and the difference', pressed('all') && !$('legend').hidden, '');
    key('s');
    $('slide').value = 1000; $('slide').dispatchEvent(new Event('input')); const left = pixel(...spot);
    $('slide').value = 0; $('slide').dispatchEvent(new Event('input')); const right = pixel(...spot);
    check('slides', left === '200,100,50' && right === '100,200,50', `${left} ${right}`);
    $('scale').value = '16'; $('scale').dispatchEvent(new Event('change')); key('d'); await wait(100); check('difference', pixel(...spot) === '252,255,164', pixel(...spot));
    for (const [kind, unit] of [['signed', 'mean'], ['relative', '%'], ['flip', 'FLIP'], ['ssim', 'SSIM']]) {
      $('map').value = kind; $('map').dispatchEvent(new Event('change')); for (let k = 0; k < 50000 && !$('legend-unit').textContent.includes(unit); k++) await turn();
      check(`map: ${kind}`, $('legend-unit').textContent.includes(unit), $('legend-unit').textContent);
    }
    check('FLIP histogram', !$('flip').hidden && document.querySelectorAll('#flip-histogram rect').length === 33, $('flip-histogram').getAttribute('aria-label'));
    $('map').value = 'difference'; $('map').dispatchEvent(new Event('change')); await wait(100);
    key('p'); check('oracle', pixel(...spot) === left, pixel(...spot));
    key('v'); check('native', pixel(...spot) === right, pixel(...spot));
    key('b'); const seen = new Set(); for (let i = 0; i < 16; i++) { seen.add(pixel(...spot)); await wait(100); }
    check('blinks', seen.size === 2, [...seen]);
    key('2'); check('side by side', pressed('all'), '');
    key('v');
    const pixels = $('suspects').querySelector('button'), bare = pixel(...spot); pixels.click();
    check('a suspect shows its pixels', pixels.getAttribute('aria-pressed') === 'true' && pixel(...spot) !== bare, `${bare} ${pixel(...spot)}`);
    pixels.click(); check('and hides them', pixels.getAttribute('aria-pressed') === 'false' && pixel(...spot) === bare, pixel(...spot));
    key('s'); key('0');
    const before = parseInt($('zoomed').textContent, 10); key('+');
    check('zooms', parseInt($('zoomed').textContent, 10) === 2 * before, $('zoomed').textContent); key('-');
    const r = canvas.getBoundingClientRect();
    canvas.dispatchEvent(new PointerEvent('pointermove', { clientX: r.left + spot[0], clientY: r.top + spot[1], bubbles: true }));
    const cells = [...document.querySelectorAll('.readout tbody td:not(.alpha)')].map(td => td.textContent).join(' ');
    check('numbers under the cursor', cells === '200 100 50 100 200 50 -100 +100 0', cells);
    const worst = document.querySelector('#worst button'); worst.click();
    check('worst pixel', $('where').textContent === 'pixel ' + worst.textContent.split(':')[0] && $('zoomed').textContent === '4000 %', $('where').textContent);
    check('explain', $('explain').textContent.includes('verisim explain'), $('explain').textContent.slice(0, 40));
    check('one click leads to the ray tree', !$('tree').hidden && $('tree').querySelector('pre').textContent.includes('camera ray'), $('tree').textContent.slice(0, 60));
    check('names what wrong pixels have in common', $('common').textContent.includes('granite') && $('common').querySelectorAll('tr').length === 2, $('common').textContent);
    check('lists the objects', $('objects').querySelector('button').textContent === 'box (a.pov:7)', $('objects').textContent);
    check('shows the known answer', !$('truth').hidden && $('points').querySelectorAll('tr').length === 2 && $('formula').textContent.includes('cos'), $('points').textContent);
    key('ArrowRight', canvas); check('arrows move the cursor', $('where').textContent !== 'pixel ' + worst.textContent.split(':')[0], $('where').textContent);
    check('histogram', document.querySelectorAll('#histogram rect').length > 3, $('histogram').getAttribute('aria-label'));
    const name = $('name').textContent; key('j'); await wait(200); check('next scene', $('name').textContent !== name, $('name').textContent);
    key('Escape'); await wait(200); check('back', $('detail').hidden && !$('overview').hidden, '');
    const back = getComputedStyle(document.body).backgroundColor; $('theme').click();
    check('light and dark', getComputedStyle(document.body).backgroundColor !== back, back);
    const unlabelled = [...document.querySelectorAll('button, input, select')].filter(e => !e.textContent.trim() && !e.getAttribute('aria-label') && !e.closest('label'));
    check('controls have names', unlabelled.length === 0, unlabelled.map(e => e.id));
    check('fits the width', document.documentElement.scrollWidth <= document.documentElement.clientWidth, `${document.documentElement.scrollWidth} ${document.documentElement.clientWidth}`);
    out.textContent += 'END\n';
  } catch (error) { check('runs', false, error.stack); }
})();
