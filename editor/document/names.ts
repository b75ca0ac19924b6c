import type { FoundObject, ObjectKind } from './objects.ts';

/** What people call a kind: one and many. */
export const KIND_NAMES: Readonly<Record<ObjectKind, readonly [one: string, many: string]>> = {
  astronaut: ['Astronaut', 'Astronaut'],
  blackHole: ['Black hole', 'Black hole'],
  asteroid: ['Asteroid', 'asteroids'],
  nova: ['Nova', 'novae'],
  repulsor: ['Repulsor', 'repulsors'],
  alien: ['Alien', 'aliens'],
  mineral: ['Mineral', 'minerals'],
};

/** `Hot asteroid 3`: the number counts within its list, from 1. */
export function nameOf({ kind, list, index, object }: FoundObject): string {
  const [one] = KIND_NAMES[kind];
  if (list === null) return one;
  const hot = kind === 'asteroid' && 'hot' in object && object.hot === true;
  return `${hot ? 'Hot asteroid' : one} ${index + 1}`;
}
