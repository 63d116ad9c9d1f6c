// Accepting and refusing what changed: with `verisim review`, keys and notes; in a file, what was decided, to read.
const decisionOf = s => data.review && data.review.decisions[s.name];
const undecided = () => scenes.filter(s => !passed(s) && !decisionOf(s)).length;
function reviewState(s) {
  $('review').hidden = !data.review || passed(s);
  if ($('review').hidden) return;
  const d = decisionOf(s), writes = !!data.served;
  $('accept').hidden = $('refuse').hidden = $('withdraw').hidden = !writes;
  $('withdraw').disabled = !d;
  $('accept').setAttribute('aria-pressed', !!d && d.decision === 'accepted');
  $('refuse').setAttribute('aria-pressed', !!d && d.decision === 'refused');
  $('note').readOnly = !writes; $('note').value = d ? d.note : '';
  $('decided').textContent = d ? `${d.decision}${d.stored ? ', stored' : ''}` : writes ? 'not decided yet' : 'not decided yet; `verisim review` decides';
}
function reviewBar() {
  $('review-bar').hidden = !data.review;
  if (!data.review) return;
  const count = what => scenes.filter(s => decisionOf(s) && decisionOf(s).decision === what).length, waiting = scenes.filter(s => decisionOf(s) && decisionOf(s).decision === 'accepted' && !decisionOf(s).stored).length;
  $('review-text').textContent = `${undecided()} to decide, ${count('accepted')} accepted, ${count('refused')} refused` + (data.review.baseline ? `; baseline ${data.review.baseline}` : '');
  $('store').hidden = !data.served || !data.review.baseline;
  $('store').disabled = !waiting;
  $('store').textContent = waiting ? `Store the ${waiting} accepted` : 'Store what is accepted';
}
async function send(what, body) {
  try {
    const reply = await fetch(what, { method: 'POST', body: JSON.stringify(body) });
    if (!reply.ok) throw new Error(await reply.text());
    data.review.decisions = (await reply.json()).decisions;
    $('review-error').textContent = '';
  } catch (error) { $('review-error').textContent = `Not written: ${error.message}`; }
  reviewBar(); paintRows(true);
  if (eye.index >= 0) reviewState(scenes[eye.index]);
}
async function decide(decision) {
  if (!data.served || $('review').hidden) return;
  const s = scenes[eye.index];
  await send('decide', { scene: s.name, decision, note: $('note').value });
  if (decision !== 'open' && decisionOf(s) && decisionOf(s).decision === decision) nextUndecided();
}
function nextUndecided() {
  const at = view.order.indexOf(eye.index), later = [...view.order.slice(at + 1), ...view.order.slice(0, at + 1)].find(i => !passed(scenes[i]) && !decisionOf(scenes[i]));
  if (later !== undefined) location.replace('#' + later);
}
$('accept').onclick = () => decide('accepted'); $('refuse').onclick = () => decide('refused'); $('withdraw').onclick = () => decide('open');
$('store').onclick = () => send('store', {});
$('note').onchange = () => { const d = decisionOf(scenes[eye.index]); if (d && d.note !== $('note').value) send('decide', { scene: scenes[eye.index].name, decision: d.decision, note: $('note').value }); };
