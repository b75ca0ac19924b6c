import { type AccuracyName, compile, createSimulation, DEFAULT_MAX_TIME, TICK_RATE } from '../../../engine/index.ts';
import { largestDistance, pathOf } from '../../../engine/work-precision/index.ts';
import type { LiveProof } from '../../proof/index.ts';
import { useDebouncedProof } from '../parts/index.ts';

/** ms without a change before the comparison, which simulates two whole runs */
const REST = 300;

/** ms: a run that takes longer is not compared */
const SLOW = 100;

const MAX_TICKS = DEFAULT_MAX_TIME * TICK_RATE;

/** Compares the path at the current accuracy with `arcade`, or `arcade` with `precise`. */
function otherOf({ level, scene, accuracy, run, limit, ms }: LiveProof) {
  if (limit !== null || ms > SLOW) return null;
  const name: AccuracyName = accuracy === 'arcade' ? 'precise' : 'arcade';
  const path = pathOf(createSimulation(compile(level, name)), run.holds, MAX_TICKS);
  const distance = largestDistance(path, pathOf(createSimulation(scene), run.holds, MAX_TICKS));
  return { name, distance, isSame: (path.ending?.outcome ?? 'timeout') === run.outcome };
}

const px = (distance: number): string => (distance >= 0.05 ? distance.toFixed(1) : distance.toPrecision(1));

/** Whether another accuracy would give the same outcome for the shown run, in a few words. */
export function OtherAccuracy() {
  const other = useDebouncedProof(otherOf, REST);
  if (other === null) return null;
  const { name, distance, isSame } = other;
  return (
    <span className={isSame ? undefined : 'tone--warn'}>
      {isSame ? `${name} would differ by ${px(distance)} px, same verdict` : `${name} would end differently`}
    </span>
  );
}
