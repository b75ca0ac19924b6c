import { boxOf, compile } from '../../../engine/index.ts';
import { type Disc, rulesOf } from '../../../schema/basics/index.ts';
import type { Goal } from '../../goal.ts';
import { successProbability } from '../../measure/robustness/index.ts';
import type { Random } from '../../random.ts';
import { type Candidate, verifyRun } from '../../verified-run.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { fits, type Layout, NOVA_MARGIN } from './layout.ts';
import { toLevel } from './level-file.ts';
import type { Stage } from './stage.ts';
import { distanceToWays, forgives, tubeOf, type Way } from './tube.ts';

const ANY: Goal = { minerals: 'any' };
const ALL: Goal = { minerals: 'all' };

const RADIUS = 16;

// Ticks by which the edges of mistimed runs are shifted, at most, and px from their ways to a nova on each axis, at most.
const MISTIMED = 5;
const OFF = 24;

// Places that are tried for one nova.
const PLACES = 40;

const SAMPLES = 100;

// px beyond what her box needs, within which novae are tried beside the path.
const NEAR = 30;

// How far success must stay above the wanted value, because it is measured again, and more precisely, in the end.
const RESERVE = 0.06;

/**
 * Adds one nova beside a run's path: the one that reduces success under timing noise of 40 ms most, without going below the
 * wanted success or breaking the certificate.
 * @returns the layout, or null when there is no such place
 */
export function narrowWay(
  layout: Layout,
  spec: GeneratorSpec,
  run: Candidate,
  way: Way,
  random: Random,
  { slots, detour }: Stage,
): Layout | null {
  const p40 = (grown: Layout) =>
    successProbability(compile(toLevel(grown), 'arcade'), run.holds, ANY, 40, { samples: SAMPLES, seed: 1 }).p;
  const now = p40(layout);
  const least = RADIUS + boxOf(rulesOf(layout)).halfDiagonal + 1;
  const isBeside = (nova: Disc): boolean => {
    const away = distanceToWays([way], nova) - nova.radius + RADIUS;
    return away >= least && away <= least + NEAR && fits(layout, spec, nova, undefined, NOVA_MARGIN);
  };
  const narrowed: { readonly layout: Layout; readonly p: number }[] = [];
  const weigh = (nova: Disc): void => {
    if (!isBeside(nova)) return;
    const grown = { ...layout, novae: [...layout.novae, nova] };
    const p = p40(grown);
    if (p < now - 0.01 && p >= spec.p40 + RESERVE) narrowed.push({ layout: grown, p });
  };
  const beside = slots.filter(isBeside);
  for (let i = 0; i < PLACES && beside.length > 0; i++) weigh(beside.splice(random.below(beside.length), 1)[0]);
  // otherwise where mistimed runs pass, since a nova elsewhere changes nothing
  if (narrowed.length === 0) {
    const mistimed = tubeOf(compile(toLevel(layout), 'arcade'), run.holds, MISTIMED, random);
    for (let i = 0; i < PLACES; i++) {
      const passes = mistimed[random.below(mistimed.length)];
      const { x, y } = passes[random.below(passes.length)];
      const off = () => random.below(2 * OFF + 1) - OFF;
      weigh({ x: Math.round(x) + off(), y: Math.round(y) + off(), radius: RADIUS });
    }
  }
  narrowed.sort((a, b) => a.p - b.p);
  const isOpen = (grown: Layout) => {
    const scene = compile(toLevel(grown), 'arcade');
    if (detour !== null && verifyRun(scene, detour.holds, ALL) === null) return false;
    return forgives(scene, run.holds, spec.certifiedTicks, random);
  };
  return narrowed.find((grown) => isOpen(grown.layout))?.layout ?? null;
}
