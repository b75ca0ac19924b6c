import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Desk } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import type { DocumentEvent } from '../../core/document/index.ts';
import { ofDocument } from '../../core/kept/index.ts';
import type { SessionStore } from '../../core/session/index.ts';
import {
  createFormerSlack,
  type FormerRun,
  figuresOf,
  formerOf,
  isShown,
  MEASURING,
  playsLike,
  replayFormer,
  type ShownSlack,
  type SlackKnown,
  shownSlack,
} from './former.ts';
import { rowsInWords, rowsOf, whyUnknown } from './rows.ts';

/** What the page compares the shown run with. */
export interface Comparison {
  /** null: nothing is compared. */
  readonly former: FormerRun | null;
  /** `held`: the change is in progress. `ended`: it has just ended. `asked`: by the command. */
  readonly phase: 'held' | 'ended' | 'asked';
  /** The slack of the former run. */
  readonly slack: SlackKnown;
  /** The slack of the shown run. */
  readonly slackNow: SlackKnown;
  /** The differences when the last change ended, for a screen reader. */
  readonly said: string;
}

/** What the shown run of a level is compared with. */
export const onionOf = ofDocument(() =>
  createStore<Comparison>(() => ({ former: null, phase: 'ended', slack: MEASURING, slackNow: MEASURING, said: '' })),
);

/** Compares with before the last change. */
export const COMPARE_KEY = 'Shift+b';

/** ms that a comparison stays after the change has ended: enough to read it */
export const STAYS = 6000;
/** ms that a spoken comparison waits for the slack of both runs */
export const WAITS = 2500;

/** The comparison of the shown run with what it was before a change. */
export interface OnionSession {
  /** A key or the pointer was released: a change in progress may have ended. */
  released(): void;
  /** The user goes on to something else: the comparison of a change that has ended disappears. */
  dismiss(): void;
  /** Why there is nothing to compare with; null: there is. */
  needs(): string | null;
  /** Shows or hides the comparison with before the last change. */
  toggle(): void;
  close(): void;
}

interface OnionParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof'>;
  readonly session: SessionStore;
  readonly desk: Desk;
  /** The robustness of the shown run, which the Solver panel shows. */
  readonly robustness: Pick<StoreApi<ShownSlack>, 'getState' | 'subscribe'>;
}

/**
 * While the layer is shown, keeps a copy of the shown run of the level at rest. During a change it is compared with the run as it
 * becomes.
 */
export function watchOnion({ level, session, desk, robustness }: OnionParts): OnionSession {
  const { document, proof } = level;
  const store = onionOf(level);
  const former = createFormerSlack(desk, robustness);
  const isOn = () => session.getState().layers.onion;
  const isInHand = () => document.committedFile() !== document.file();
  /** The shown run of the level at rest, and what it was before the last step. */
  let atRest: FormerRun | null = null;
  let last: FormerRun | null = null;
  /** The number of steps when `last` was set: a step that grows does not change it. */
  let done = document.store.getState().done;
  let forgetTimer = () => {};
  let forgetSpeech = () => {};

  const hide = () => {
    forgetTimer();
    forgetSpeech();
    former.forget();
    if (store.getState().former !== null) store.setState({ former: null });
  };
  const show = (run: FormerRun, phase: 'held' | 'asked') => {
    const now = store.getState();
    if (now.former === run && now.phase === phase) return;
    forgetTimer();
    forgetSpeech();
    const slack = former.ask(run, (known) => {
      if (store.getState().former === run) store.setState({ slack: known });
    });
    store.setState({ former: run, phase, slack, slackNow: shownSlack(robustness.getState()), said: '' });
  };
  const speak = () => {
    const { former: run, slack, slackNow } = store.getState();
    if (run === null) return;
    forgetSpeech();
    const now = figuresOf(proof.proof());
    const rows = rowsOf(run.figures, now, { before: slack, now: slackNow });
    store.setState({ said: rowsInWords(rows, whyUnknown(run.figures, now)) });
  };
  /** Says it as soon as the slack of both runs is known. */
  const speakSoon = () => {
    let stop = () => {};
    const look = () => {
      const { former: run, slack, slackNow } = store.getState();
      if (run !== null && (slack === MEASURING || slackNow === MEASURING)) return false;
      speak();
      return true;
    };
    if (look()) return;
    const forget = desk.after(WAITS, speak);
    stop = store.subscribe(look);
    forgetSpeech = () => {
      forgetSpeech = () => {};
      forget();
      stop();
    };
  };
  const end = () => {
    if (store.getState().former === null || store.getState().phase !== 'held') return;
    store.setState({ phase: 'ended' });
    forgetTimer = desk.after(STAYS, hide);
    speakSoon();
  };

  const onProof = () => {
    if (!isOn()) return;
    const now = proof.proof();
    if (isInHand()) {
      if (atRest !== null && atRest.file === document.committedFile() && !playsLike(atRest, now)) show(atRest, 'held');
      return;
    }
    const before = atRest;
    atRest = formerOf(now);
    if (before === null) return;
    if (before.file === now.file) {
      // a gesture was cancelled, another run is shown, or the terms are others
      const isSame = isShown(before, now) && before.level === now.level;
      if (before.level !== now.level) last = null;
      if (!isSame || store.getState().former?.file === now.file) hide();
      return;
    }
    const steps = document.store.getState().done;
    if (steps !== done || last === null || !document.isGrowing()) last = before;
    done = steps;
    if (document.isGrowing() && isShown(last, now) && !playsLike(last, now)) show(last, 'held');
    else hide();
  };
  /** The end of a gesture: nothing visible changes. */
  const onStep = (event: DocumentEvent) => {
    if (!isOn() || atRest?.file === event.file) return;
    const before = atRest;
    atRest = formerOf(proof.proof());
    // the layer was hidden when the gesture began
    if (before?.file !== event.before) return;
    last = before;
    done = document.store.getState().done;
    end();
  };
  const onRobustness = () => {
    if (!isOn()) return;
    const slackNow = shownSlack(robustness.getState());
    if (atRest !== null && !isInHand() && atRest.file === proof.proof().file) former.keep(atRest, slackNow);
    if (store.getState().former !== null) store.setState({ slackNow });
  };
  const look = () => {
    if (isOn()) {
      atRest ??= isInHand() ? null : formerOf(proof.proof());
      return;
    }
    hide();
    store.setState({ said: '' });
    atRest = null;
    last = null;
  };
  look();
  onRobustness();
  let wasOn = isOn();
  const stops = [
    proof.store.subscribe(onProof),
    document.onStep(onStep),
    robustness.subscribe(onRobustness),
    session.subscribe(() => {
      if (isOn() === wasOn) return;
      wasOn = isOn();
      look();
    }),
  ];
  return {
    released() {
      const { former: run, phase } = store.getState();
      if (run === null || phase !== 'held' || isInHand()) return;
      // a gesture that has changed nothing ends without a step
      if (document.isGrowing()) {
        end();
        return;
      }
      hide();
      atRest = formerOf(proof.proof());
    },
    dismiss() {
      if (store.getState().phase === 'ended') hide();
    },
    needs() {
      if (!isOn()) return 'show the run before and after a change first';
      return last === null ? 'change something first' : null;
    },
    toggle() {
      const { former: run, phase } = store.getState();
      if (run !== null && phase === 'asked') {
        hide();
        return;
      }
      if (last === null || isInHand()) return;
      last = replayFormer(last, proof.proof());
      show(last, 'asked');
      speakSoon();
    },
    close() {
      for (const stop of stops) stop();
      hide();
    },
  };
}

// what the user did last

/** The last input anywhere on the page: a key, or the pointer and where it was, px of the page. */
export type Input = { readonly by: 'keys' } | { readonly by: 'mouse' | 'touch'; readonly x: number; readonly y: number };

let last: Input = { by: 'keys' };

export const lastInput = (): Input => last;

/** Follows the input until aborted. */
export function followInput(signal: AbortSignal): void {
  // before other listeners, as some of them stop the event
  const options = { capture: true, passive: true, signal };
  const onPointer = ({ clientX: x, clientY: y, pointerType }: PointerEvent) => {
    last = { by: pointerType === 'touch' ? 'touch' : 'mouse', x, y };
  };
  const onKey = () => {
    last = { by: 'keys' };
  };
  window.addEventListener('pointerdown', onPointer, options);
  // a drag goes on while a modifier is pressed, and a mouse that is moved without a button changes nothing
  window.addEventListener('pointermove', (event) => event.buttons !== 0 && onPointer(event), options);
  window.addEventListener('keydown', onKey, options);
}
