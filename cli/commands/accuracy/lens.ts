import { decidedInWords, waysApart } from '../../../check/runs/index.ts';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { ACCURACIES, compile, type Run, type Scene, type Terms, TICK } from '../../../engine/index.ts';
import { pathOfRun } from '../../../engine/work-precision/index.ts';
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
    return withinWorkOf(scene, holds, (run) => ({ accuracy, run, way: { points: pointsOf(run, scene), events: run.events } }));
  });
  const exact = played.find(({ accuracy }) => accuracy.name === ACCURACIES.precise.name)!;
  return played.map(({ accuracy, run, way }) => {
    const {
      partings: { parts },
      decided,
    } = waysApart(exact.way, way);
    const words = [`${accuracy.name} ${outcomeAsPredicate(run, level.range)}`];
    if (parts !== null) words.push(`a pixel from precise at ${(parts * TICK).toFixed(2)} s`);
    if (decided !== null) words.push(decidedInWords(decided, 'precise'));
    return { run, label: words.join('; '), glows: parts === null ? null : parts * TICK };
  });
}

/** x, y at every tick and at the end. */
function pointsOf(run: Run, scene: Scene): number[] {
  const { count, x, y } = pathOfRun(run, scene);
  return [...Array.from({ length: count }, (_, tick) => [x[tick], y[tick]]), [run.final.x, run.final.y]].flat();
}
