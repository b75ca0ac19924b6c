import { boxCircleGap, effectEventInWords, STATE_SIZE, TICK } from '../../../engine/index.ts';
import { appearanceOfObject } from '../../../schema/index.ts';
import { type FoundObject, placesOf } from '../../core/document/index.ts';
import { type Fact, pixels, plural, seconds } from '../../core/figures/index.ts';
import { endInWords, type LiveProof } from '../../core/proof/index.ts';
import { chasesIn, insideIn, lengthOf, type OwnEvent, ownEvents, pullsIn, pushesIn, type Stretch, tickOf } from './stretches.ts';

const at = (time: number): string => `at ${seconds(time)}`;

/** Where an object is at a tick; null once it is gone. */
type Places = (tick: number) => readonly { readonly x: number; readonly y: number }[] | null;

function placesIn({ run }: LiveProof, found: FoundObject): Places {
  const { kind, index } = found;
  const { aliens, asteroids } = run.way;
  if (kind === 'alien') {
    const state = new Float64Array(3);
    return (tick) => {
      aliens.read(index, tick, state);
      return state[2] === 0 ? null : [{ x: state[0], y: state[1] }];
    };
  }
  if (kind === 'asteroid' && asteroids.count > 0) {
    const state = new Float64Array(2);
    return (tick) => {
      asteroids.read(index, tick, state);
      return [{ x: state[0], y: state[1] }];
    };
  }
  const still = placesOf(found);
  return () => still;
}

/** What of her an object acts on: discs that are entered act on her centre alone. */
type Part = 'box' | 'centre';

const CENTRE = { halfWidth: 0, halfHeight: 0, halfDiagonal: 0 } as const;

/**
 * The closest distance between her and an object in the shown run, sampled once per tick.
 * @param radius px
 * @returns the gap to the rim in px, negative if they overlap; null if the object is never there
 */
export function nearestPass(
  proof: LiveProof,
  found: FoundObject,
  radius: number,
  part: Part,
): { gap: number; tick: number } | null {
  const { states, count } = proof.run.way;
  const box = part === 'box' ? proof.scene.box : CENTRE;
  const placesAt = placesIn(proof, found);
  let best: { gap: number; tick: number } | null = null;
  for (let tick = 0; tick < count; tick++) {
    const o = STATE_SIZE * tick;
    const places = placesAt(tick);
    if (places === null) break;
    for (const { x, y } of places) {
      const gap = boxCircleGap(box, x - states[o], y - states[o + 1], states[o + 4], states[o + 5], radius);
      if (best === null || gap < best.gap) best = { gap, tick };
    }
  }
  return best;
}

/** `2 times, 3.1 s from 1.20 s`, with the tick of the first */
function stretchFact(label: string, stretches: readonly Stretch[], never: string): Fact {
  if (stretches.length === 0) return { label, value: never };
  const many = stretches.length === 1 ? '' : `${stretches.length} times, `;
  return {
    label,
    value: `${many}${seconds(lengthOf(stretches))} from ${seconds(stretches[0].from)}`,
    tick: tickOf(stretches[0].from),
  };
}

/** @param over what she does where the box lies over an object that nothing comes of; null: the events know of each contact */
function passFact(proof: LiveProof, found: FoundObject, radius: number, isDeadly: boolean, over: string | null = null): Fact[] {
  const pass = nearestPass(proof, found, radius, 'box');
  if (pass === null) return [];
  const { gap, tick } = pass;
  const tone = isDeadly && gap < 8 ? (gap <= 0 ? 'bad' : 'warn') : undefined;
  const value = gap <= 0 && over !== null ? `${over} ${at(tick * TICK)}` : `${pixels(Math.max(0, gap))} ${at(tick * TICK)}`;
  return [{ label: 'closest distance', value, tick, ...(tone === undefined ? {} : { tone }) }];
}

/** How near her centre comes to a disc that she stays out of. */
function centreFact(proof: LiveProof, found: FoundObject, radius: number): Fact[] {
  const pass = nearestPass(proof, found, radius, 'centre');
  if (pass === null || pass.gap < 0) return [];
  return [{ label: 'closest distance', value: `${pixels(pass.gap)} from her centre ${at(pass.tick * TICK)}`, tick: pass.tick }];
}

/** What a disc does to her while her centre is inside; else how near she comes. */
function discFacts(proof: LiveProof, found: FoundObject, radius: number, label: string, stretches: readonly Stretch[]): Fact[] {
  if (stretches.length > 0) return [stretchFact(label, stretches, 'never')];
  const near = centreFact(proof, found, radius);
  return [stretchFact(label, [], near.length > 0 ? 'never: she stays outside' : 'never'), ...near];
}

/** What an object with an effect of its own does: what the effect tells, and when her centre is inside. */
function ownFacts(proof: LiveProof, found: FoundObject, radius: number, own: readonly OwnEvent[]): Fact[] {
  const label = 'her centre is inside';
  const acts = own.filter(({ what }) => what !== 'enter' && what !== 'leave');
  if (acts.length > 0) {
    const [first] = acts;
    const many = acts.length === 1 ? '' : `, ${acts.length} times in all`;
    return [{ label: 'she', value: `${effectEventInWords(first)} ${at(first.time)}${many}`, tick: tickOf(first.time) }];
  }
  if (own.length > 0) return [stretchFact(label, insideIn(own, proof.run.time), 'never')];
  // nothing is told of an object that she begins in and never leaves
  const pass = nearestPass(proof, found, radius, 'centre');
  if (pass !== null && pass.gap < 0) return [{ label, value: at(pass.tick * TICK), tick: pass.tick }];
  return discFacts(proof, found, radius, label, []);
}

/** Whether and when the run ends at this object. */
function endFact({ run }: LiveProof, { kind, index }: FoundObject): Fact[] {
  if (run.with === null || run.with.kind !== kind || run.with.index !== index) return [];
  const good = run.outcome === 'completed';
  return [{ label: 'the run', value: `ends here ${at(run.time)}`, tick: run.tick, tone: good ? 'good' : 'bad' }];
}

/** What an object does in the shown run. @param radius of the object, with defaults filled in */
export function runFactsOf(proof: LiveProof, found: FoundObject, radius: number | null): readonly Fact[] {
  const { kind, index, object } = found;
  const { full, level } = proof;
  if (full === null) return [{ label: 'the run', value: endInWords(proof), tone: 'warn' }];
  const { events } = full;
  if (kind === 'astronaut' || radius === null) return wayFacts(proof);
  const end = endFact(proof, found);
  switch (kind) {
    case 'asteroid': {
      const hot = level.asteroids[index]?.hot === true;
      const pulls = stretchFact('pulls her', pullsIn(proof, events, index), 'never');
      return [...end, pulls, ...(end.length > 0 ? [] : passFact(proof, found, radius, hot, hot ? null : 'she flies through it'))];
    }
    case 'mineral': {
      const taken = full.minerals.find((mineral) => mineral.index === index);
      if (taken === undefined)
        return [{ label: 'collected', value: 'no', tone: 'warn' }, ...passFact(proof, found, radius, false)];
      return [{ label: 'collected', value: at(taken.time), tick: tickOf(taken.time), tone: 'good' }];
    }
    case 'repulsor':
      return discFacts(proof, found, radius, 'pushes her', pushesIn(proof, events, index));
    case 'alien': {
      const burst = events.find((event) => event.type === 'explosion' && event.aliens.includes(index));
      const awake = stretchFact('awake', chasesIn(proof, events, index), 'never: it does not see her');
      const other = burst?.type === 'explosion' ? burst.aliens.find((alien) => alien !== index) : undefined;
      const bursts: Fact[] =
        burst === undefined || other === undefined
          ? []
          : [{ label: 'explodes', value: `with alien ${other + 1} ${at(burst.time)}`, tick: tickOf(burst.time) }];
      return [...end, awake, ...bursts, ...(end.length > 0 ? [] : passFact(proof, found, radius, true))];
    }
    case 'nova':
    case 'blackHole':
      return end.length > 0 ? end : passFact(proof, found, radius, appearanceOfObject(kind, object).deadly);
    default:
      return ownFacts(proof, found, radius, ownEvents(events, found.list, index));
  }
}

/** The facts of the shown run as a whole. */
export function wayFacts(proof: LiveProof): readonly Fact[] {
  const { run, margins, level } = proof;
  const { speed, gap } = margins;
  let fastest = 0;
  let closest = 0;
  for (let tick = 1; tick < speed.length; tick++) {
    if (speed[tick] > speed[fastest]) fastest = tick;
    if (gap[tick] < gap[closest]) closest = tick;
  }
  const facts: Fact[] = [
    { label: 'gun', value: run.holds.length === 0 ? 'never held' : `${plural(run.holds.length, 'press', 'presses')}` },
    { label: 'top speed', value: `${Math.round(speed[fastest] ?? 0)} px/s ${at(fastest * TICK)}`, tick: fastest },
  ];
  if (gap.length > 0 && Number.isFinite(gap[closest])) {
    const tone = gap[closest] < 8 ? ({ tone: 'warn' } as const) : {};
    facts.push({
      label: 'least clearance',
      value: `${pixels(Math.max(0, gap[closest]))} ${at(closest * TICK)}`,
      tick: closest,
      ...tone,
    });
  }
  if (level.minerals.length > 0) {
    facts.push({ label: 'minerals', value: `${run.minerals.length} of ${level.minerals.length}` });
  }
  return facts;
}
