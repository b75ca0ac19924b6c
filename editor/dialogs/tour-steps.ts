/** A place of the page and what there is to know about it. */
export interface TourStep {
  readonly title: string;
  readonly text: string;
  /** For a finger, where that does something else. */
  readonly touch?: string;
  /** Selectors of the place, the first that is there counts; none: the middle of the page. */
  readonly at: readonly string[];
}

/** The whole editor in under a minute. */
export const TOUR: readonly TourStep[] = [
  {
    title: 'Build the level here',
    text: 'Drag things to move them, drag their rim to make them larger. The wheel zooms, the right button moves the view.',
    touch:
      'Drag things to move them, drag their rim to make them larger. A finger on empty space moves the view, two fingers zoom.',
    at: ['[aria-label="Level canvas"]'],
  },
  {
    title: 'Put things in',
    text: 'Choose a tool and click, or drag it to its place. Each has a letter: A for an asteroid, N for a nova, M for a mineral.',
    touch: 'Choose a tool and tap where the thing is to be: an asteroid, a nova, a mineral. The arrow selects again.',
    at: ['[role=toolbar][aria-label="Tools"]'],
  },
  {
    title: 'The proof is always on',
    text: 'The line is where the run takes her. It bends while you drag, and the verdict follows at once: it is that of gq check.',
    at: ['[aria-label^="Verdict"]'],
  },
  {
    title: 'A run is one lane',
    text: 'A bar is how long the gun is held. Drag it, stretch its ends; with Alt all that follows moves along. Click the ruler to look at any moment.',
    touch: 'A bar is how long the gun is held. Drag it, stretch its ends. Tap the ruler to look at any moment.',
    at: ['section[aria-label="Timeline"]', '.narrow__sheet--timeline', '.narrow__tabs'],
  },
  {
    title: 'Play it in place',
    text: 'Space plays, Esc comes back. Hold the mouse button for the gun. An attempt that gets through can become the proof.',
    touch:
      'Play starts, and the same button comes back. Hold a finger down for the gun. An attempt that gets through can become the proof.',
    at: ['.topbar .button--main'],
  },
  {
    title: 'Levels, objects, numbers',
    text: 'All levels with their verdicts, every object by name, numbers to type, problems to go to, and a solver that looks for runs.',
    at: ['aside[aria-label="Levels and objects"]', '.narrow__tabs'],
  },
  {
    title: 'Everything has a name',
    text: 'Ctrl K finds any command, ? shows all keys. All you do is saved at once and can be undone. Have fun!',
    touch: 'The magnifier finds any command by its name. All you do is saved at once and can be undone. Have fun!',
    at: ['.topbar__search'],
  },
];
