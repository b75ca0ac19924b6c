import { createStore, type StoreApi } from 'zustand/vanilla';
import { ACCURACY_NAMES } from '../../../schema/index.ts';
import { fits, flag, number, object, oneOf, orNull, type Shape, text, type ValueOf } from '../../../schema/level/index.ts';

const SETTINGS = object({
  theme: oneOf(['system', 'dark', 'light']),
  /** The renderer; a page keeps the one it started with. */
  renderer: oneOf(['automatic', 'webgl', 'canvas']),
  /** px between grid lines */
  grid: number(1, 256),
  snapToGrid: flag,
  snapToObjects: flag,
  /** Whether rulers stand along the canvas. */
  rulers: flag,
  /** Whether the whole level is shown in a corner while part of it is out of view. */
  minimap: flag,
  sound: flag,
  /** 0 to 1 */
  volume: number(0, 1),
  /** `KeyboardEvent.code` of the gun key in a playtest */
  gunKey: text(),
  /** Whether the run's path is shown in a playtest as well. */
  runInPlay: flag,
  /** Whether the holds of the shown run are re-timed when a change of the level breaks it. */
  keepAlive: flag,
  reduceMotion: oneOf(['system', 'yes', 'no']),
  /** The accuracy at which the open level is shown; null: that at which `gq check` judges the folder. */
  otherAccuracy: orNull(oneOf(ACCURACY_NAMES)),
  tourSeen: flag,
  /** The address of a published page, for links that only play a level; '': none is known. */
  playPage: text(undefined, 2000),
});

/** The user's preferences, kept in this browser for all levels. */
export type Settings = ValueOf<typeof SETTINGS>;
export type SettingsStore = StoreApi<Settings>;

const DEFAULTS: Settings = {
  theme: 'system',
  renderer: 'automatic',
  grid: 8,
  snapToGrid: true,
  snapToObjects: true,
  rulers: false,
  minimap: true,
  sound: true,
  volume: 0.5,
  gunKey: 'KeyX',
  runInPlay: false,
  keepAlive: false,
  reduceMotion: 'system',
  otherAccuracy: null,
  tourSeen: false,
  playPage: '',
};

const KEY = 'gravity-quest-editor-settings';

/**
 * The accuracy that earlier pages have stored, whether or not anybody had chosen it: `precise`, their default, says nothing and
 * must not hide the folder's.
 */
function formerAccuracy({ accuracy }: { readonly accuracy?: unknown }): Settings['otherAccuracy'] {
  return fits(accuracy, SETTINGS.keys.otherAccuracy) && accuracy !== 'precise' ? accuracy : null;
}

/** Reads the stored settings one by one: an invalid one falls back to its default without affecting the others. */
function restored(text: string | null): Settings {
  let kept: unknown = null;
  try {
    kept = JSON.parse(text ?? 'null');
  } catch {
    // nothing usable was stored
  }
  if (typeof kept !== 'object' || kept === null) return DEFAULTS;
  const settings: Record<string, unknown> = { ...DEFAULTS, otherAccuracy: formerAccuracy(kept) };
  for (const [name, shape] of Object.entries<Shape>(SETTINGS.keys)) {
    const value = (kept as Record<string, unknown>)[name];
    if (fits(value, shape)) settings[name] = value;
  }
  return settings as Settings;
}

/**
 * The settings, kept in `storage` from now on.
 * @param storage the page's localStorage, or null if the browser refuses one
 */
export function createSettings(storage: Pick<Storage, 'getItem' | 'setItem'> | null): SettingsStore {
  const store = createStore<Settings>(() => restored(storage?.getItem(KEY) ?? null));
  store.subscribe((settings) => {
    try {
      storage?.setItem(KEY, JSON.stringify(settings));
    } catch {
      // the storage is full or forbidden: the settings last until the page is closed
    }
  });
  return store;
}
