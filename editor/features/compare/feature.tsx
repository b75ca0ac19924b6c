import { useMemo } from 'react';
import type { DrawnPart } from '../../canvas/index.ts';
import { type Beside, looksLike } from '../../timeline/index.ts';
import type { Feature } from '../feature.ts';
import { ComparedLanes } from './ComparedLanes.tsx';
import { compareCommands, compareDestinations } from './compare-commands.ts';
import { useComparedRows } from './compared-rows.ts';
import { RaceLayer } from './race-layer.ts';
import { type Race, raceOf } from './racers.ts';
import { useDifference } from './use-difference.ts';
import { watchCompared } from './watch-compared.ts';

const drawn: DrawnPart<Race> = {
  pictureOf: raceOf,
  draw: (scene, theme) => new RaceLayer(scene, theme),
};

/** What the timeline shows of compared runs beside the shown one. */
function useBeside(): Beside {
  const ticks = useComparedRows().reduce(
    (most, { found }) => Math.max(most, found === null ? 0 : Math.ceil(60 * found.end.time)),
    0,
  );
  const difference = useDifference();
  const [against, distances, partings] = [difference?.row.name, difference?.distances, difference?.partings];
  const apart = useMemo(
    () => (against && distances && partings ? { name: against, distances, partings } : null),
    [against, distances, partings],
  );
  return { ticks, apart };
}

/** Runs beside the shown one: their ways and lanes, and how they differ. */
export const compare: Feature = {
  name: 'compare',
  canvas: { drawn },
  timeline: {
    lanes: ComparedLanes,
    useBeside,
    legend: {
      graphs: [[looksLike('apart'), 'The distance to the compared run; bars where they part and come near each other again.']],
    },
  },
  levelCommands: compareCommands,
  destinations: compareDestinations,
  open: ({ desk }, level) => watchCompared(level, desk),
};
