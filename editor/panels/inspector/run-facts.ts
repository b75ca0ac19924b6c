import { boxCircleGap, type RunEvent, STATE_SIZE, TICK, TICK_RATE } from '../../../engine/index.ts';
import { appearanceOfObject } from '../../../schema/index.ts';
import { type FoundObject, placesOf } from '../../document/index.ts';
import { endInWords, type LiveProof } from '../../proof/index.ts';
import { type Fact, pixels, plural, seconds } from '../figures/index.ts';

const tickOf = (time: number): number => Math.floor(time * TICK_RATE + 1e-9);
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

/**
 * The closest distance between the collision box and an object in the shown run, sampled once per tick.
 * @param radius px
 * @returns the gap between box and rim in px, negative if they overlap; null if the object is never there
 */
export function nearestPass(proof: LiveProof, found: FoundObject, radius: number): { gap: number; tick: number } | null {
  const { states, count } = proof.run.way;
  const { box } = proof.scene;
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

/** The intervals in which an asteroid is the target of the held gun, s. */
export function pullsOf(events: readonly RunEvent[], asteroid: number, end: number): { from: number; to: number }[] {
  const pulls: { from: number; to: number }[] = [];
  let from: number | null = null;
  const close = (to: number) => {
    if (from !== null) pulls.push({ from, to });
    from = null;
  };
  for (const event of events) {
    if (event.type === 'target') {
      close(event.time);
      if (event.index === asteroid) from = event.time;
    } else if (event.type === 'release') close(event.time);
  }
  close(end);
  return pulls;
}

/** The intervals between two types of events of the same object, s; the end of the run may cut off the last. */
function between(events: readonly RunEvent[], index: number, first: 'enter' | 'wake', last: 'leave' | 'sleep', end: number) {
  const stretches: { from: number; to: number }[] = [];
  let from: number | null = null;
  for (const event of events) {
    if (!('index' in event) || event.index !== index) continue;
    if (event.type === first) from ??= event.time;
    if (event.type === last && from !== null) {
      stretches.push({ from, to: event.time });
      from = null;
    }
  }
  if (from !== null) stretches.push({ from, to: end });
  return stretches;
}

const lengthOf = (stretches: readonly { from: number; to: number }[]): number =>
  stretches.reduce((sum, { from, to }) => sum + to - from, 0);

/** `2 times, 3.1 s from 1.20 s`, with the tick of the first */
function stretchFact(label: string, stretches: readonly { from: number; to: number }[], never: string): Fact {
  if (stretches.length === 0) return { label, value: never };
  const many = stretches.length === 1 ? '' : `${stretches.length} times, `;
  return {
    label,
    value: `${many}${seconds(lengthOf(stretches))} from ${seconds(stretches[0].from)}`,
    tick: tickOf(stretches[0].from),
  };
}

function passFact(proof: LiveProof, found: FoundObject, radius: number, isDeadly: boolean): Fact[] {
  const pass = nearestPass(proof, found, radius);
  if (pass === null) return [];
  const { gap, tick } = pass;
  const tone = isDeadly && gap < 8 ? (gap <= 0 ? 'bad' : 'warn') : undefined;
  const value = gap <= 0 ? `touched ${at(tick * TICK)}` : `${pixels(gap)} ${at(tick * TICK)}`;
  return [{ label: 'closest distance', value, tick, ...(tone === undefined ? {} : { tone }) }];
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
  const { run, full, level } = proof;
  if (full === null) return [{ label: 'the run', value: endInWords(proof), tone: 'warn' }];
  const { events } = full;
  if (kind === 'astronaut' || radius === null) return wayFacts(proof);
  const end = endFact(proof, found);
  switch (kind) {
    case 'asteroid': {
      const hot = level.asteroids[index]?.hot === true;
      const pulls = stretchFact('pulls her', pullsOf(events, index, run.time), 'never');
      return [...end, pulls, ...(end.length > 0 ? [] : passFact(proof, found, radius, hot))];
    }
    case 'mineral': {
      const taken = full.minerals.find((mineral) => mineral.index === index);
      if (taken === undefined)
        return [{ label: 'collected', value: 'no', tone: 'warn' }, ...passFact(proof, found, radius, false)];
      return [{ label: 'collected', value: at(taken.time), tick: tickOf(taken.time), tone: 'good' }];
    }
    case 'repulsor': {
      const inside = stretchFact('pushes her', between(events, index, 'enter', 'leave', run.time), 'never: she stays outside');
      return [inside, ...passFact(proof, found, radius, false)];
    }
    case 'alien': {
      const burst = events.find((event) => event.type === 'explosion' && event.aliens.includes(index));
      const gone = burst?.time ?? run.time;
      const awake = stretchFact('awake', between(events, index, 'wake', 'sleep', gone), 'never: it does not see her');
      const other = burst?.type === 'explosion' ? burst.aliens.find((alien) => alien !== index) : undefined;
      const bursts: Fact[] =
        burst === undefined || other === undefined
          ? []
          : [{ label: 'explodes', value: `with alien ${other + 1} ${at(burst.time)}`, tick: tickOf(burst.time) }];
      return [...end, awake, ...bursts, ...(end.length > 0 ? [] : passFact(proof, found, radius, true))];
    }
    default:
      return end.length > 0 ? end : passFact(proof, found, radius, appearanceOfObject(kind, object).deadly);
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
