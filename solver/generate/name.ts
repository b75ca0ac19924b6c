import type { Random } from '../random.ts';
import type { ThemeName } from './theme-name.ts';

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

/** Second words that say what the level is like. */
const OF_THEME: Readonly<Record<ThemeName, readonly string[]>> = {
  orbits: ['Carousel', 'Circle', 'Crown', 'Halo', 'Moon', 'Orbit', 'Ring', 'Round', 'Satellite', 'Waltz', 'Wheel', 'Whirl'],
  corridors: [
    'Aisle',
    'Alley',
    'Avenue',
    'Canal',
    'Channel',
    'Colonnade',
    'Hallway',
    'Lane',
    'Passage',
    'Street',
    'Tunnel',
    'Walk',
  ],
  slings: ['Arrow', 'Catapult', 'Crossing', 'Dash', 'Flight', 'Gate', 'Leap', 'Shot', 'Sling', 'Throw', 'Vault', 'Voyage'],
  lures: ['Bait', 'Bargain', 'Decoy', 'Glitter', 'Jewel', 'Lure', 'Pocket', 'Purse', 'Siren', 'Temptation', 'Treasure', 'Wager'],
  fields: ['Barrage', 'Barrier', 'Breeze', 'Cushion', 'Dyke', 'Fence', 'Hedge', 'Levee', 'Shield', 'Surf', 'Wall', 'Weir'],
};

/** A random name for a level, made of two words. */
export function nameLevel(random: Random, theme: ThemeName | null): string {
  const second = theme === null ? SECOND : OF_THEME[theme];
  return `${FIRST[random.below(FIRST.length)]} ${second[random.below(second.length)]}`;
}
