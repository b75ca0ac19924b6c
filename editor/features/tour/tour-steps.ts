/** One step of the tour: a place on the page and what to know about it. */
export interface TourStep {
  readonly title: string;
  readonly text: string;
  /** The text for touch, where it differs. */
  readonly touch?: string;
  /** Selectors of the place, the first that matches counts; none: the middle of the page. */
  readonly at: readonly string[];
}

/** A tour of the whole editor in under a minute. */
export const TOUR: readonly TourStep[] = [
  {
    title: 'Build the level here',
    text: 'Drag an object to move it, drag its rim to resize it. Scroll to zoom, drag with the right button to move the view, click with it for a menu.',
    touch:
      'Drag an object to move it, drag its rim to resize it. Drag on empty space to move the view, pinch to zoom, rest a finger for a menu.',
    at: ['[aria-label="Level canvas"]'],
  },
  {
    title: 'Add objects',
    text: 'Choose a tool and click on the canvas, or drag the tool there. Each tool has a key: A for an asteroid, N for a nova, M for a mineral.',
    touch:
      'Choose a tool, such as an asteroid, a nova or a mineral, and tap on the canvas to place it. The arrow goes back to selecting.',
    at: ['[role=toolbar][aria-label="Tools"]'],
  },
  {
    title: 'The verdict is always live',
    text: 'The line shows the path of the run. It follows while you drag, and so does the verdict, which is the one that gq check gives. The dashed line is the path before the drag, with what is better and worse beside it. The heart in the timeline keeps the run alive meanwhile.',
    at: ['[aria-label^="Verdict"]'],
  },
  {
    title: 'A run is a row of holds',
    text: 'Each bar is a hold of the gun. Drag it to move it, drag its ends to stretch it; hold Alt to move everything after it as well. Click the ruler to see any moment. C compares with another run, T shows the run as text.',
    touch: 'Each bar is a hold of the gun. Drag it to move it, drag its ends to stretch it. Tap the ruler to see any moment.',
    at: ['section[aria-label="Timeline"]', '.narrow__sheet--timeline', '.narrow__tabs'],
  },
  {
    title: 'Play it right here',
    text: 'Press Space to play, Esc to return. Hold the mouse button or one of a gamepad to hold the gun; [ plays in slow motion. You can keep each attempt as a run of the level.',
    touch:
      'Tap Play to start, and again to return. Hold a finger down to hold the gun. You can keep each attempt as a run of the level.',
    at: ['.topbar .button--main'],
  },
  {
    title: 'Levels, objects, numbers',
    text: 'Here are all levels with their verdicts, also as cards in order, all objects, the numbers of what is selected, the problems, and a solver that searches for runs.',
    at: ['aside[aria-label="Levels and objects"]', '.narrow__tabs'],
  },
  {
    title: 'Find any command',
    text: 'Press Ctrl+K to find any command, ? for all shortcuts. Every change is saved at once and can be undone; Y shows earlier versions. Have fun!',
    touch: 'Tap the magnifier to find any command, also the history. Every change is saved at once and can be undone. Have fun!',
    at: ['.topbar__search'],
  },
];
