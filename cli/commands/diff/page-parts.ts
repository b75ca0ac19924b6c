/**
 * The script of the page: it moves both ghosts along their runs by the slider, or with time. It reads what it needs from the
 * page and loads nothing.
 */
export const PLAYER = `'use strict';
const levels = JSON.parse(document.getElementById('runs').textContent);
let playing = null;
for (const section of document.querySelectorAll('section[data-level]')) {
  const slider = section.querySelector('input');
  if (slider === null) continue;
  const { runs, ticks } = levels[section.dataset.level];
  const button = section.querySelector('button');
  const output = section.querySelector('output');
  const head = section.querySelector('.head');
  const ghosts = runs.map(({ when }) => section.querySelector('.ghost.' + when));
  const show = () => {
    const tick = Number(slider.value);
    runs.forEach(({ at }, i) => {
      const last = at.length / 3 - 1;
      const k = 3 * Math.min(tick, last);
      ghosts[i].setAttribute('transform', 'translate(' + at[k] + ' ' + at[k + 1] + ')');
      ghosts[i].querySelector('rect').setAttribute('transform', 'rotate(' + at[k + 2] + ')');
    });
    const text = (tick / 60).toFixed(2) + ' s (tick ' + tick + ')';
    output.textContent = text;
    slider.setAttribute('aria-valuetext', text);
    if (head) for (const x of ['x1', 'x2']) head.setAttribute(x, String((1000 * tick) / ticks));
  };
  const stop = () => {
    button.textContent = 'Play';
    playing = null;
  };
  const step = (from, start) => (now) => {
    if (playing !== section) return button.textContent === 'Play' ? undefined : stop();
    slider.value = String(Math.min(ticks, Math.round(from + (now - start) * 0.06)));
    show();
    if (Number(slider.value) >= ticks) stop();
    else requestAnimationFrame(step(from, start));
  };
  slider.addEventListener('input', () => {
    if (playing === section) stop();
    show();
  });
  button.addEventListener('click', () => {
    if (playing === section) return stop();
    for (const other of document.querySelectorAll('section[data-level] button')) other.textContent = 'Play';
    if (Number(slider.value) >= ticks) slider.value = '0';
    playing = section;
    button.textContent = 'Pause';
    requestAnimationFrame((now) => step(Number(slider.value), now)(now));
  });
  show();
}
`;

/** The style of the page. It is light or dark as the reader's system is. */
export const STYLE = `
:root { color-scheme: light dark; --ground: #f5f7fc; --panel: #fff; --text: #151b33; --muted: #566087; --rule: #ccd3e6;
  --good: #0b7540; --bad: #c01818; --before: #a35f00; --after: #1a5fb4; --focus: #1a5fb4; }
@media (prefers-color-scheme: dark) { :root { --ground: #070a16; --panel: #0f1530; --text: #eef2ff; --muted: #a3aed4;
  --rule: #2a3355; --good: #6ee7a0; --bad: #ff7d7d; --before: #ffd166; --after: #7fbaff; --focus: #7fbaff; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--text); font: 16px/1.5 system-ui, sans-serif; }
main, header { max-width: 1240px; margin: 0 auto; padding: 16px; }
h1 { font-size: 22px; margin: 8px 0; overflow-wrap: anywhere; }
h2 { font-size: 18px; margin: 0; overflow-wrap: anywhere; }
h3 { font-size: 15px; margin: 0 0 6px; color: var(--muted); font-weight: 600; }
p { margin: 6px 0; }
a { color: var(--after); }
nav ul { padding: 0; list-style: none; columns: 320px; }
nav li { overflow-wrap: anywhere; }
section { background: var(--panel); border: 1px solid var(--rule); border-radius: 10px; padding: 16px; margin: 0 0 24px; }
.name { color: var(--muted); margin: 0 0 8px; overflow-wrap: anywhere; }
.badge { display: inline-block; border: 1.5px solid currentColor; border-radius: 999px; padding: 0 10px; font-size: 14px;
  font-weight: 600; }
.good { color: var(--good); } .bad { color: var(--bad); } .plain { color: var(--muted); }
.columns { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 20px; }
.pair { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 16px; margin-top: 16px; }
@media (max-width: 760px) { .columns, .pair { grid-template-columns: minmax(0, 1fr); } main, header { padding: 10px; }
  section { padding: 10px; } }
.words { margin: 4px 0 12px; padding-left: 20px; overflow-wrap: anywhere; }
.effects { list-style: none; margin: 0; padding: 8px 12px; border-left: 3px solid var(--muted); overflow-wrap: anywhere; }
.effects.bad { border-color: var(--bad); } .effects.good { border-color: var(--good); }
figure { margin: 0; }
.stage { position: relative; border-radius: 8px; overflow: hidden; border: 1px solid var(--rule); }
img, .stage svg { display: block; width: 100%; height: auto; }
.stage svg { position: absolute; inset: 0; height: 100%; }
.way { fill: none; stroke-linejoin: round; stroke-linecap: round; }
.before .way, .ghost.before rect { stroke: var(--before); } .after .way, .ghost.after rect { stroke: var(--after); }
.way.free { stroke-width: 2; } .way.held { stroke-width: 5; } .before .way { stroke-dasharray: 7 5; }
.ghost rect { fill: var(--panel); fill-opacity: .75; stroke-width: 3; } .ghost.before rect { stroke-dasharray: 4 2; }
.ghost text { font: 700 15px system-ui, sans-serif; text-anchor: middle; fill: var(--text); }
.controls { display: flex; align-items: center; gap: 12px; margin: 10px 0 4px; }
button { font: inherit; min-width: 76px; min-height: 40px; border-radius: 8px; border: 1px solid var(--muted);
  background: var(--ground); color: var(--text); cursor: pointer; }
input[type=range] { flex: 1; min-width: 0; height: 40px; accent-color: var(--after); }
:focus-visible { outline: 3px solid var(--focus); outline-offset: 2px; }
output { min-width: 9.5em; text-align: right; font-variant-numeric: tabular-nums; }
.ends { display: flex; flex-wrap: wrap; gap: 2px 20px; margin: 0; font-size: 14px; }
.key { font-weight: 600; } .key.before { color: var(--before); } .key.after { color: var(--after); }
.lanes { display: block; width: 100%; height: 62px; }
.lanes .lane { fill: var(--rule); } .lanes .before { fill: var(--before); } .lanes .after { fill: var(--after); }
.lanes .edge { stroke: var(--text); stroke-width: 2; vector-effect: non-scaling-stroke; }
.lanes .head { stroke: var(--text); stroke-width: 1.5; vector-effect: non-scaling-stroke; }
.edges { font-size: 14px; color: var(--muted); margin: 4px 0 0; }
`;
