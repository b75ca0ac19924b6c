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
