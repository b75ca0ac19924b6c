import type { Random } from '../random.ts';

const FIRST = [
  ...['Amber', 'Borrowed', 'Broken', 'Copper', 'Crooked', 'Distant', 'Drowsy', 'Dusty', 'Eleventh', 'Faint', 'Fallen', 'Far'],
  ...['Gentle', 'Glass', 'Hidden', 'Hollow', 'Idle', 'Indigo', 'Iron', 'Late', 'Leaning', 'Little', 'Lone', 'Long', 'Lost'],
  ...['Narrow', 'Northern', 'Old', 'Open', 'Pale', 'Patient', 'Quiet', 'Restless', 'Rusty', 'Second', 'Silver', 'Sleeping'],
  ...['Slow', 'Steady', 'Stray', 'Tidal', 'Twin', 'Velvet', 'Wandering', 'Wide', 'Winter'],
] as const;

const SECOND = [
  ...['Anchor', 'Arc', 'Beacon', 'Bend', 'Bridge', 'Cradle', 'Crossing', 'Current', 'Drift', 'Ember', 'Errand', 'Eddy'],
  ...['Ferry', 'Gap', 'Garden', 'Gate', 'Harbour', 'Hook', 'Lantern', 'Ledge', 'Loop', 'Mile', 'Needle', 'Orbit'],
  ...['Passage', 'Pendulum', 'Pier', 'Promise', 'Reach', 'Ridge', 'Round', 'Shallows', 'Shore', 'Signal', 'Spiral', 'Swing'],
  ...['Tether', 'Thread', 'Tide', 'Trail', 'Turn', 'Vault', 'Wake', 'Waltz', 'Way'],
] as const;

/** A random name for a level, made of two words. */
export const nameLevel = (random: Random): string =>
  `${FIRST[random.below(FIRST.length)]} ${SECOND[random.below(SECOND.length)]}`;
