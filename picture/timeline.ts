import { type Run, TICK } from '../engine/index.ts';
import type { Hold } from '../schema/index.ts';
import { drawText } from './text.ts';
import type { Theme } from './theme.ts';
import { heldTimes } from './way.ts';
import { num } from './xml.ts';

const HEIGHT = 9;

/** The least distance between two marks, and between two labels, in units. */
const MARK_ROOM = 30;
const LABEL_ROOM = 69;

// Seconds between two marks: wide pictures get at most about thirty marks.
const STEPS = [1, 2, 5, 10, 30, 60, 300, 600];

/** Draws the holds as blocks on a timeline with a mark for each second. */
export function drawTimeline(
  theme: Theme,
  x: number,
  y: number,
  width: number,
  run: Run | undefined,
  holds: readonly Hold[] | undefined,
): string {
  const held =
    holds?.map(([press, release]): [number, number] => [press * TICK, release * TICK]) ??
    (run === undefined ? [] : heldTimes(run));
  const end = run?.time ?? held.reduce((last, [, release]) => Math.max(last, release), 0);
  if (!(end > 0)) return '';
  const at = (time: number): number => x + (width * Math.min(time, end)) / end;
  const blocks = held
    .filter(([press]) => press < end)
    .map(
      ([press, release]) =>
        `<rect x="${num(at(press))}" y="${num(y)}" width="${num(Math.max(1, at(release) - at(press)))}" height="${HEIGHT}" rx="2"/>`,
    )
    .join('');
  const step = STEPS.find((s) => end / s <= width / MARK_ROOM) ?? 3600;
  const label = STEPS.find((s) => s % step === 0 && end / s <= width / LABEL_ROOM) ?? 3600;
  let marks = '';
  let labels = '';
  for (let time = 0; time <= end; time += step) {
    marks += `M${num(at(time))} ${num(y + HEIGHT + 2)}v${time % label === 0 ? 5 : 3}`;
    if (time % label === 0)
      labels += drawText(`${time} s`, at(time), y + HEIGHT + 17, {
        size: 6.5,
        color: theme.muted,
        anchor: time === 0 ? 'start' : 'middle',
      });
  }
  return (
    `<g data-kind="timeline"><rect x="${num(x)}" y="${num(y)}" width="${num(width)}" height="${HEIGHT}" rx="2" fill="${theme.rule}"/>` +
    `<g fill="${theme.gun}">${blocks}</g><path d="${marks}" stroke="${theme.muted}" stroke-width="1"/>${labels}</g>`
  );
}
