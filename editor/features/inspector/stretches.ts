import { type RunEvent, TICK_RATE } from '../../../engine/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';

/** A part of a run, s. */
export interface Stretch {
  readonly from: number;
  readonly to: number;
}

export const lengthOf = (stretches: readonly Stretch[]): number => stretches.reduce((sum, { from, to }) => sum + to - from, 0);

/** What is left of stretches outside of others. */
export const without = (stretches: readonly Stretch[], others: readonly Stretch[]): readonly Stretch[] =>
  others.reduce<readonly Stretch[]>(
    (left, { from, to }) =>
      left.flatMap((one) =>
        to <= one.from || from >= one.to
          ? [one]
          : [
              { from: one.from, to: from },
              { from: to, to: one.to },
            ].filter((part) => part.to > part.from),
      ),
    stretches,
  );

interface Ends {
  /** Whether it holds when the run begins, of which there is no event. */
  readonly atStart: boolean;
  readonly begins: (event: RunEvent) => boolean;
  readonly ends: (event: RunEvent) => boolean;
  /** When the run, or what it is about, is over, s. */
  readonly end: number;
}

/** The stretches between two kinds of events; the end of the run may cut off the last. */
function between(events: readonly RunEvent[], { atStart, begins, ends, end }: Ends): Stretch[] {
  const stretches: Stretch[] = [];
  let from: number | null = atStart ? 0 : null;
  const close = (to: number) => {
    if (from !== null && to > from) stretches.push({ from, to });
    from = null;
  };
  for (const event of events) {
    if (ends(event)) close(event.time);
    if (begins(event)) from ??= event.time;
  }
  close(end);
  return stretches;
}

/** Whether the start is nearer to a place than a distance, as the engine decides it. */
function startsWithin({ level }: LiveProof, { x, y }: { readonly x: number; readonly y: number }, distance: number): boolean {
  const dx = x - level.astronaut.x;
  const dy = y - level.astronaut.y;
  return dx * dx + dy * dy < distance * distance;
}

/** When an asteroid is the target of the held gun. */
export function targetedIn(events: readonly RunEvent[], asteroid: number, end: number): Stretch[] {
  return between(events, {
    atStart: false,
    begins: (event) => event.type === 'target' && event.index === asteroid,
    ends: ({ type }) => type === 'target' || type === 'release',
    end,
  });
}

/** When her centre is in a repulsor; in frames, when it is the one that acts. */
function inRepulsor(proof: LiveProof, events: readonly RunEvent[], index: number): Stretch[] {
  const repulsor = proof.level.repulsors[index];
  return between(events, {
    // frames tell of the field that she begins in
    atStart: proof.terms.accuracy.integrator !== 'arcade' && startsWithin(proof, repulsor, repulsor.radius),
    begins: (event) => event.type === 'enter' && event.index === index,
    ends: (event) => event.type === 'leave' && event.index === index,
    end: proof.run.time,
  });
}

/** What is left of stretches while she is in none of the first repulsors of the list. */
const outsideOfFirst = (proof: LiveProof, events: readonly RunEvent[], stretches: readonly Stretch[], count: number) =>
  proof.level.repulsors
    .slice(0, count)
    .reduce((left, _, i) => (left.length === 0 ? left : without(left, inRepulsor(proof, events, i))), stretches);

/** When a repulsor pushes her: where several overlap, the first in the list acts. */
export function pushesIn(proof: LiveProof, events: readonly RunEvent[], index: number): readonly Stretch[] {
  const { repulsors } = proof.level;
  const { x, y, radius } = repulsors[index];
  // a copy of an earlier one never acts, and has no events of its own
  if (repulsors.slice(0, index).some((one) => one.x === x && one.y === y && one.radius === radius)) return [];
  return outsideOfFirst(proof, events, inRepulsor(proof, events, index), index);
}

/** When an asteroid pulls her: it is the target, and no repulsor pushes her instead. */
export const pullsIn = (proof: LiveProof, events: readonly RunEvent[], asteroid: number): readonly Stretch[] =>
  outsideOfFirst(proof, events, targetedIn(events, asteroid, proof.run.time), proof.level.repulsors.length);

/** An event that an effect of an object defines for itself. */
export type OwnEvent = Extract<RunEvent, { type: 'effect' }>;

/** The events that an object's own effect tells of it; the effect is called like the list. */
export const ownEvents = (events: readonly RunEvent[], list: string | null, index: number): OwnEvent[] =>
  events.flatMap((event) => (event.type === 'effect' && event.effect === list && event.index === index ? [event] : []));

/** When her centre is inside, by events that tell of entering and leaving: one that she begins in, she leaves first. */
export const insideIn = (own: readonly OwnEvent[], end: number): Stretch[] =>
  between(own, {
    atStart: own[0]?.what === 'leave',
    begins: (event) => event.type === 'effect' && event.what === 'enter',
    ends: (event) => event.type === 'effect' && event.what === 'leave',
    end,
  });

/** When an alien chases her, until it explodes. */
export function chasesIn(proof: LiveProof, events: readonly RunEvent[], index: number): Stretch[] {
  const burst = events.find((event) => event.type === 'explosion' && event.aliens.includes(index));
  return between(events, {
    atStart: startsWithin(proof, proof.level.aliens[index], proof.scene.rules.alienSight),
    begins: (event) => event.type === 'wake' && event.index === index,
    ends: (event) => event.type === 'sleep' && event.index === index,
    end: burst?.time ?? proof.run.time,
  });
}

/** The tick that a time falls in. */
export const tickOf = (time: number): number => Math.floor(time * TICK_RATE + 1e-9);
