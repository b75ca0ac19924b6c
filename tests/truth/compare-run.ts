import { type Run, STATE_SIZE } from '../../engine/index.ts';
import type { Reference } from './references.ts';

/** s and px: what `precise` promises, times a run's own sensitivity. */
const PROMISE = 1e-9;

const ending = (run: Pick<Run, 'outcome' | 'with'> | Reference) =>
  run.with === null ? run.outcome : `${run.outcome} with ${run.with.kind} ${run.with.index}`;

/** Whether a run ends as the reference does, with the same thing. */
export const sameEnding = (run: Run, reference: Reference): boolean => ending(run) === ending(reference);

/** Distance between the places where run and reference end, px. */
export const distanceAtEnd = (run: Run, reference: Reference): number =>
  Math.hypot(run.final.x - reference.final.x, run.final.y - reference.final.y);

/** Everything that happened, in words, in the order of time. */
function happenings(of: { time: number; what: string }[]): { time: number; what: string }[] {
  return [...of].sort((a, b) => a.time - b.time || (a.what < b.what ? -1 : 1));
}

function happeningsOfRun(run: Run): { time: number; what: string }[] {
  return happenings(
    run.events.flatMap((e, i) => {
      switch (e.type) {
        case 'mineral':
          return [{ time: e.time, what: `mineral ${e.index}` }];
        case 'enter':
        case 'leave':
          return [{ time: e.time, what: `${e.type} field ${e.index}` }];
        case 'wake':
        case 'sleep':
          return [{ time: e.time, what: `${e.type} alien ${e.index}` }];
        case 'explosion':
          return [{ time: e.time, what: `explosion ${e.aliens.join(' ')}` }];
        case 'target':
          // the one a press begins with is no change
          return run.events[i - 1]?.type === 'press' ? [] : [{ time: e.time, what: `target ${e.index}` }];
        default:
          return [];
      }
    }),
  );
}

function happeningsOfReference(r: Reference): { time: number; what: string }[] {
  return happenings([
    ...r.minerals.map((m) => ({ time: m.time, what: `mineral ${m.index}` })),
    ...r.events,
    ...r.switches.map((s) => ({ time: s.time, what: `target ${s.to}` })),
    ...r.explosions.map((e) => ({ time: e.time, what: `explosion ${e.aliens.join(' ')}` })),
  ]);
}

/**
 * Holds a run at `precise` against its reference: how it ends, what happens in which order and when, where she is each
 * second and at the end, and how near she came to a hazard.
 * @returns every difference in words; empty when they agree within what is promised
 */
export function differences(run: Run, reference: Reference): string[] {
  const found: string[] = [];
  if (!sameEnding(run, reference)) return [`${ending(run)} at ${run.time} s; ${ending(reference)} at ${reference.time} s`];
  const place = PROMISE * Math.max(1, reference.sensitivity);
  const time = PROMISE * Math.max(1, reference.timeSensitivity);
  const sample = PROMISE * Math.max(1, reference.sampleSensitivity);
  const near = (what: string, is: number, want: number, within: number) => {
    if (!(Math.abs(is - want) <= within)) found.push(`${what} ${is}, reference ${want}, within ${within}`);
  };

  near('time', run.time, reference.time, time);
  near('final x', run.final.x, reference.final.x, place);
  near('final y', run.final.y, reference.final.y, place);
  near('final vx', run.final.vx, reference.final.vx, place);
  near('final vy', run.final.vy, reference.final.vy, place);

  const state = new Float64Array(STATE_SIZE);
  for (const [t, ...wanted] of reference.samples) {
    if (t > run.trajectory.duration) continue;
    run.trajectory.at(t, state);
    for (const [i, name] of ['x', 'y', 'vx', 'vy'].entries()) near(`${name} at ${t} s`, state[i], wanted[i], sample);
  }

  const is = happeningsOfRun(run);
  const want = happeningsOfReference(reference);
  if (is.map((e) => e.what).join(', ') === want.map((e) => e.what).join(', ')) {
    for (const [i, e] of is.entries()) near(`time of ${e.what}`, e.time, want[i].time, Math.max(time, sample));
  } else {
    found.push(`what happened: ${JSON.stringify(is)}, reference ${JSON.stringify(want)}`);
  }
  const { clearance } = reference;
  if (clearance !== null) near('clearance', run.clearance?.distance ?? Number.NaN, clearance.distance, Math.max(place, sample));
  return found;
}
