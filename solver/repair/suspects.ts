import type { Level } from '../../schema/basics/index.ts';
import type { Blocker, LineEnd, Proof, Strip } from '../proofs/index.ts';
import { type ObjectRef, objectAt } from './change.ts';
import { HOLE, hazards, isSame, START } from './family.ts';

/**
 * The objects that a proof's certificate names as what stands in the way, or that its reason is about. A change of one of them
 * is the most likely to make the level completable.
 */
export function suspectsOf(level: Level, { certificate }: Proof): ObjectRef[] {
  switch (certificate.kind) {
    case 'nothing-in-range':
      return [START, ...byDistance(level, level.astronaut)];
    case 'starts-in-hazard':
      return [certificate.hazard, START];
    case 'out-of-range':
      return [HOLE, START];
    case 'covered':
      return [...hazards(level).filter((object) => overlapsHole(level, object)), HOLE];
    case 'enclosed':
      return unique(certificate.barrier.map(({ by }) => by));
    case 'line-trap':
      return [...unique([certificate.front.by, certificate.back.by]), START, { kind: 'asteroid', index: certificate.target }];
    case 'flowpipe': {
      const strips = certificate.layers.flatMap((layer) =>
        layer.flatMap((steps) => steps.flatMap(({ parts }) => parts.flatMap(({ off }): Strip[] => [...off]))),
      );
      return [...unique(strips.map(({ by }) => by)), START];
    }
    case 'doomed':
    case 'orbits':
      return [START];
  }
}

function unique(blockers: readonly (Blocker | LineEnd['by'])[]): ObjectRef[] {
  const found: ObjectRef[] = [];
  for (const blocker of blockers) {
    if (!('index' in blocker)) continue;
    const object: ObjectRef = { kind: blocker.kind, index: blocker.index };
    if (!found.some((other) => isSame(other, object))) found.push(object);
  }
  return found;
}

function byDistance({ asteroids }: Level, { x, y }: { readonly x: number; readonly y: number }): ObjectRef[] {
  const square = (i: number) => (asteroids[i].x - x) * (asteroids[i].x - x) + (asteroids[i].y - y) * (asteroids[i].y - y);
  return [...asteroids.keys()].sort((a, b) => square(a) - square(b)).map((index) => ({ kind: 'asteroid', index }));
}

function overlapsHole(level: Level, object: ObjectRef): boolean {
  const { x, y, radius } = objectAt(level, object);
  const { blackHole } = level;
  const reach = radius + blackHole.radius;
  return (x - blackHole.x) * (x - blackHole.x) + (y - blackHole.y) * (y - blackHole.y) < reach * reach;
}
