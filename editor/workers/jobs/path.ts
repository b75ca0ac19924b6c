import { compile } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { follow } from '../follow.ts';
import { job, type Played, type Work } from '../job.ts';

/** Her path with these holds, up to a tick: x, y in px at every tick and at the end. */
export const path = job<Played & { readonly holds: readonly Hold[]; readonly until: number }, { readonly points: Float32Array }>({
  name: 'path',
  lane: 'quick',
  most: 20_000,
});

/** Follows her tick by tick. */
export const pathWork: Work<typeof path> = {
  of: path,
  *steps({ level, terms, holds, until }) {
    const { points } = yield* follow(compile(level, terms), holds, until);
    return { points };
  },
};
