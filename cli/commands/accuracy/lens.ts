import { firstDifferentEvent, partingsOf } from '../../../check/runs/index.ts';
import { eventInWords, outcomeAsPredicate } from '../../../check/words/index.ts';
import { ACCURACIES, compile, createSimulation, maxTicksOf, type RunEvent, type Terms, TICK } from '../../../engine/index.ts';
import { pathOf } from '../../../engine/work-precision/index.ts';
import { type NamedRun, type RenderOptions, renderSvg } from '../../../picture/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { withinWorkOf } from '../../levels/index.ts';
import { visibleLine } from '../../terminal/index.ts';

/** Draws a run at all named accuracies at once: where one parts from `precise` by a pixel, its path glows. */
export const drawLens = (level: Level, name: string, ways: readonly NamedRun[], theme: RenderOptions['theme']): string =>
  renderSvg(level, {
    ways,
    theme,
    title: `${level.name} at all accuracies`,
    note: `${visibleLine(name)}; a glow is where a path is first a pixel from precise`,
  });

/**
 * A run at all named accuracies: how it ends, when it parts from `precise` by a pixel, and the first contact, or switch of a target,
 * that is another.
 * @throws Failure when a run takes more work than the terms allow
 */
export function waysAtAll(level: Level, holds: readonly Hold[], terms: Terms): NamedRun[] {
  const played = Object.values(ACCURACIES).map((accuracy) => {
    const scene = compile(level, { ...terms, accuracy });
    const path = () => pathOf(createSimulation(scene), holds, maxTicksOf(terms));
    return withinWorkOf(scene, holds, (run) => ({ accuracy, run, path: path() }));
  });
  const exact = played.find(({ accuracy }) => accuracy.name === ACCURACIES.precise.name)!;
  return played.map(({ accuracy, run, path }) => {
    const distances = Array.from({ length: Math.min(path.count, exact.path.count) }, (_, tick) => {
      const [dx, dy] = [path.x[tick] - exact.path.x[tick], path.y[tick] - exact.path.y[tick]];
      return Math.sqrt(dx * dx + dy * dy);
    });
    const { parts } = partingsOf(distances);
    const decided = firstDifferentEvent(exact.run.events, run.events);
    const words = [`${accuracy.name} ${outcomeAsPredicate(run, level.range)}`];
    if (parts !== null) words.push(`a pixel from precise at ${(parts * TICK).toFixed(2)} s`);
    if (decided !== null) words.push(`first otherwise: ${told(decided.other)}, at precise ${told(decided.one)}`);
    return { run, label: words.join('; '), glows: parts === null ? null : parts * TICK };
  });
}

const told = (event: RunEvent | undefined): string =>
  event === undefined ? 'nothing more' : `${eventInWords(event)} at ${event.time.toFixed(2)} s`;
