/** A place of the page and what there is to know about it. */
export interface TourStep {
  readonly title: string;
  readonly text: string;
  /** Selectors of the place, the first that is there counts; none: the middle of the page. */
  readonly at: readonly string[];
}

/** The whole editor in under a minute. */
export const TOUR: readonly TourStep[] = [
  {
    title: 'Build the level here',
    text: 'Drag things to move them, drag their rim to make them larger. The wheel zooms, the right button moves the view.',
    at: ['[aria-label="Level canvas"]'],
  },
  {
    title: 'Put things in',
    text: 'Choose a tool and click, or drag it to its place. Each has a letter: A for an asteroid, N for a nova, M for a mineral.',
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
    at: ['section[aria-label="Timeline"]', '.narrow__sheet'],
  },
  {
    title: 'Play it in place',
    text: 'Space plays, Esc comes back. Hold the mouse button for the gun. An attempt that gets through can become the proof.',
    at: ['.topbar .button--main'],
  },
  {
    title: 'Levels, objects, numbers',
    text: 'Left: all levels with their verdicts, and every object by name. Right: numbers to type, problems to go to, and a solver that looks for runs.',
    at: ['aside[aria-label="Levels and objects"]', '.narrow__tabs'],
  },
  {
    title: 'Everything has a name',
    text: 'Ctrl K finds any command, ? shows all keys. All you do is saved at once and can be undone. Have fun!',
    at: ['.topbar__search'],
  },
];
