import type { EditedLevel, Gesture, Recipe } from '../document/index.ts';
import type { SessionStore } from './session.ts';

/** An offered change that the page shows as if it were taken: a change in progress, as while an object is dragged. */
export interface Preview {
  isShown(): boolean;
  /**
   * Shows a change in place of one that is shown.
   * @param label of the step, once it is taken
   * @param run the run that shows what it does
   */
  show(label: string, recipe: Recipe, run: string): void;
  /** Keeps what is shown, as one step of the history. */
  take(): void;
  /** Shows the level and the run as they were. */
  back(): void;
  /** A step of the history has ended it: it was taken, or another change took it along. */
  ended(): void;
}

export function createPreview(document: Pick<EditedLevel, 'begin'>, session: SessionStore): Preview {
  let gesture: Gesture | null = null;
  let shownBefore: string | null = null;
  const back = () => {
    if (gesture === null) return;
    // it still counts as shown while the page follows
    gesture.cancel();
    gesture = null;
    session.setState({ run: shownBefore });
  };
  return {
    isShown: () => gesture !== null,
    show(label, recipe, run) {
      back();
      shownBefore = session.getState().run;
      gesture = document.begin(label);
      gesture.set(recipe);
      session.setState({ run });
    },
    take: () => gesture?.commit(),
    back,
    ended() {
      gesture = null;
    },
  };
}
