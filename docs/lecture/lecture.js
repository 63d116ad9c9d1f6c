// Where the pages are served by `verisim view --lecture`, scenes can be changed and pixels asked; as files they are still.
'use strict';
const post = (name, body) => fetch(name, { method: 'POST', body: JSON.stringify(body) });

function live(figure) {
  const image = figure.querySelector('img'), text = figure.querySelector('textarea'), message = document.createElement('pre'), told = document.createElement('pre');
  const asked = () => ({ name: figure.dataset.name, text: text.value, width: +figure.dataset.width, height: +figure.dataset.height, switches: figure.dataset.switches });
  told.className = 'told';
  told.setAttribute('aria-live', 'polite');
  figure.classList.add('live');
  figure.append(told, message);
  let busy = false, again = false;
  const draw = async () => {
    if (busy) { again = true; return; }
    busy = true;
    do {
      again = false;
      try {
        const reply = await post('draw', asked());
        message.textContent = reply.ok ? '' : await reply.text();
        if (reply.ok) { const old = image.src; image.src = URL.createObjectURL(await reply.blob()); if (old.startsWith('blob:')) URL.revokeObjectURL(old); }
      } catch { message.textContent = 'verisim view does not answer'; }
    } while (again);
    busy = false;
  };
  text.addEventListener('input', draw);
  image.addEventListener('click', async e => {
    const box = image.getBoundingClientRect(), x = Math.floor((e.clientX - box.left) / box.width * figure.dataset.width), y = Math.floor((e.clientY - box.top) / box.height * figure.dataset.height);
    const reply = await post('pixel', { ...asked(), x, y });
    told.textContent = await reply.text();
  });
}

fetch('live').then(reply => { if (reply.ok) document.querySelectorAll('figure.scene').forEach(live); }).catch(() => {});
