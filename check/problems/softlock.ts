import { TICK } from '../../engine/index.ts';
import type { Softlocks } from '../softlocks.ts';
import { plural } from '../words/index.ts';
import type { Hints } from './hints.ts';
import type { CheckProblem } from './problem.ts';

/** She lives on for long if she was seen alive for this long after all is lost, s. */
const LONG = 5;

/** The problem that she can live on for long after it is proved to be lost. */
export function softlock(found: Softlocks | null, { seeLost }: Hints): CheckProblem[] {
  const long = found?.places.filter(({ standing, alive }) => standing.is === 'proved' && alive * TICK >= LONG) ?? [];
  const [worst] = long;
  if (worst?.standing.is !== 'proved') return [];
  const more = long.length === 1 ? '' : `, and at ${plural(long.length - 1, 'more place')}`;
  return [
    {
      code: 'softlock',
      severity: 'warning',
      message:
        `she can live on for ${(worst.alive * TICK).toFixed(1)} s and more although the black hole is out of her reach: ` +
        `from ${(worst.tick * TICK).toFixed(2)} s on at (${Math.round(worst.x)}, ${Math.round(worst.y)})${more}`,
      hint: `this is proved (${worst.standing.proof.code}) and confirmed by a separate checker: end the run there, or open a way back${seeLost}`,
      pointer: '',
    },
  ];
}
