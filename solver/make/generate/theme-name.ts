/** What a generated level is composed around. */
export type ThemeName = 'orbits' | 'corridors' | 'slings' | 'lures' | 'fields';

/** The names of all themes. */
export const THEME_NAMES: readonly ThemeName[] = ['orbits', 'corridors', 'slings', 'lures', 'fields'];

/** Of what kind the symmetry of a level is: none, a mirror image, or the same after half a turn. */
export type SymmetryKind = 'none' | 'mirror' | 'rotate';

/** Every kind of symmetry. */
export const SYMMETRIES: readonly SymmetryKind[] = ['none', 'mirror', 'rotate'];
