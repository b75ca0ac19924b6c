import { plural } from '../../../check/words/index.ts';
import { compile, simulate, type Terms } from '../../../engine/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import { readLevel } from '../../../schema/index.ts';
import { causeInWords, type MeasuredLevel } from '../../difficulty/index.ts';
import { readBytes } from '../../io/index.ts';
import { percent } from '../../report-parts/index.ts';

/** More rings than this hide the level. */
const MOST_RINGS = 6;

/**
 * Draws a level with the places where players fail, and with the run that they are compared with.
 * @returns the SVG document, or null if there is nothing to draw
 */
export function drawPlayers({ file, players }: MeasuredLevel, terms: Terms, theme: 'dark' | 'light'): string | null {
  if (players === null || players.statistics.attempts === 0) return null;
  const read = readLevel(readBytes(file), terms);
  if (!read.ok) return null;
  const { all, clusters, attempts, share, low, high, reference, players: known } = players.statistics;
  const who = known === 0 ? '' : ` of ${plural(known, 'player')}`;
  return renderSvg(read.level, {
    theme,
    run: reference === null ? undefined : simulate(compile(read.level, terms), reference.holds),
    title: `Where players of ${read.level.name} fail`,
    note: `${plural(attempts, 'attempt')}${who}: ${percent(share)} succeed (${percent(low)} to ${percent(high)})`,
    failures: {
      places: all.flatMap(({ cause, x, y }) => (cause === null ? [] : { x, y })),
      clusters: clusters.slice(0, MOST_RINGS).map(({ x, y, spread, cause, count, share: part }) => ({
        ...{ x, y, spread },
        label: `${causeInWords(cause)}, ${count} (${percent(part)})`,
      })),
    },
  });
}
