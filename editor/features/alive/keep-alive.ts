import { joinHolds } from '../../../engine/index.ts';
import type { Hold, LevelFile } from '../../../schema/index.ts';
import type { Retimed } from '../../../solver/index.ts';
import type { Desk } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { type DocumentEvent, type EditedLevel, replaceHolds, type StepMark } from '../../core/document/index.ts';
import { isWhole, type LiveProof, type ProofStore } from '../../core/proof/index.ts';
import type { SettingsStore } from '../../core/settings/index.ts';
import {
  completesNow,
  createReplacedHolds,
  type Former,
  formerOf,
  isSameGame,
  othersOf,
  type ReplacedHolds,
  replayed,
} from './former.ts';
import { type AliveState, aliveOf, type Surviving } from './index.ts';
import { type Answer, createHoldSeeker, type HoldSeeker, WITHIN } from './seek-holds.ts';

/** Turns it on or off. */
export const ALIVE_KEY = 'Shift+k';

/** Ticks that are simulated for a place that is dragged over, and for the last one. */
const EFFORT = { live: 400_000, last: 4_000_000 } as const;

/** ms without a change before the other runs are looked at, or a click is over */
const REST = 150;

/** A change of the level that the shown run is to survive. */
interface Chase {
  readonly start: LevelFile;
  readonly former: Former;
  /** Holds that were put in place of the former ones; null: none. */
  carried: readonly Hold[] | null;
  /** Where the next search begins. */
  warm: readonly Hold[] | null;
}

interface AliveParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof'>;
  readonly settings: SettingsStore;
  readonly desk: Desk;
}

/** @param isAbout whether the result is about the level as it is: otherwise its slack and minerals are not known */
function aliveState(best: Retimed, run: string, isAbout: boolean, isFinal: boolean): AliveState {
  const { edges, most, lost, slack, certified } = best;
  const known = isAbout ? { lost: lost.length, certified } : { lost: 0, certified: null };
  const least = slack?.reduce((all, { earlier, later }) => Math.min(all, earlier, later), Number.POSITIVE_INFINITY) ?? null;
  return { kind: 'alive', run, edges, most, ...known, slack: isAbout ? least : null, isFinal, others: null };
}

/**
 * While it is turned on, re-times the holds of the shown run when a change of the level breaks it, as a part of the same step. A
 * worker seeks; the page takes nothing that does not complete the level as it is now.
 * @returns stops it
 */
export function keepAlive({ level, settings, desk }: AliveParts): () => void {
  const { document, proof } = level;
  const store = aliveOf(level);
  const seeker = createHoldSeeker(proof, desk);
  const replaced = createReplacedHolds(document, proof);
  /** The shown run of each file that was shown. */
  const formers = new WeakMap<LevelFile, Former | null>();
  const remember = (now: LiveProof) => void formers.set(now.file, formerOf(now));
  let chase: Chase | null = null;
  /** Whether the level has changed since it was asked about. */
  let isStale = false;
  let forget = () => {};

  const isBroken = () => proof.proof().run.outcome !== 'completed';
  const show = (state: AliveState) => {
    if (state.kind !== 'idle' || store.getState().kind !== 'idle') store.setState(state, true);
  };
  const rest = () => {
    forget();
    seeker.stop();
    isStale = false;
  };
  const stop = () => {
    rest();
    chase = null;
    show({ kind: 'idle' });
  };
  const fail = ({ former }: Chase, isWhole: boolean, isFinal: boolean) =>
    show({ kind: 'failed', run: former.name, within: WITHIN, isWhole, isFinal, others: null });

  /**
   * Takes holds if they complete the level as it is; otherwise the next search begins with them.
   * @param step the step to extend; null: the gesture in progress carries them
   */
  const take = (current: Chase, { best, about, isLast }: Answer, step: StepMark | null): boolean => {
    if (best === null) return false;
    const { former } = current;
    current.warm = best.holds;
    if (replayed(proof.proof().scene, joinHolds(best.holds)) === null) return false;
    const before = current.carried;
    // before the change is shown, as it is looked at at once
    current.carried = best.total === 0 ? null : best.holds;
    if ((before ?? former.holds).join() !== best.holds.join()) {
      const recipe = replaceHolds(former.name, best.holds);
      const result = step === null ? document.gesture()?.also(recipe) : document.amend(step, recipe);
      if (result?.ok !== true) {
        current.carried = before;
        return false;
      }
      replaced.note(current.start, former.name, best.holds);
    }
    const isFinal = step !== null && isLast;
    show(best.total === 0 ? { kind: 'idle' } : aliveState(best, former.name, isSameGame(about.file, document.file()), isFinal));
    return true;
  };

  /** Seeks while the gesture goes on: one place after the other, the latest next. */
  const follow = (current: Chase) => {
    isStale = false;
    const question = { former: current.former, warm: current.warm, effort: EFFORT.live, certifies: false };
    seeker.ask(question, (answer) => {
      if (chase !== current || document.gesture() === null) return;
      const isTaken = take(current, answer, null);
      if (isStale && (answer.isLast || answer.best !== null)) follow(current);
      else if (answer.isLast && !isTaken && isBroken()) fail(current, answer.finished, false);
    });
  };

  /** Looks at the level after each visible change. */
  const look = ({ kind, how, start }: DocumentEvent) => {
    if (how === 'amended') return;
    if (!settings.getState().keepAlive || kind !== 'change' || how === 'replaced') {
      stop();
      return;
    }
    if (chase?.start !== start) {
      stop();
      const former = formers.get(start) ?? null;
      chase = former === null ? null : { start, former, carried: null, warm: null };
    }
    const current = chase;
    const now = proof.proof();
    if (current === null || now.run.name !== current.former.name || !isWhole(now)) return;
    // what the user does to the holds is left to the user
    if (now.run.holds.join() !== joinHolds(current.carried ?? current.former.holds).join()) {
      stop();
      return;
    }
    const about = seeker.about();
    if (about !== null && isSameGame(about.file, now.file)) return;
    if (!isBroken() && current.carried === null) {
      rest();
      show({ kind: 'idle' });
      return;
    }
    const state = store.getState();
    if (isBroken()) show({ kind: 'working' });
    else if (state.kind === 'alive') show({ ...state, slack: null, certified: null, isFinal: false });
    // a step is finished below, at once
    if (document.gesture() === null) return;
    if (seeker.isBusy) isStale = true;
    else follow(current);
  };

  const finishOthers = (start: LevelFile, step: StepMark) => {
    const shown = proof.proof().run.name;
    const wasAlive = formers.get(start)?.name === shown;
    forget = desk.afterRest(REST, () => {
      if (document.lastStep() !== step || document.gesture() !== null) return;
      rescueOthers({ document, proof, seeker, replaced }, { start, shown: wasAlive ? shown : null, step }, (others) => {
        const state = store.getState();
        if (others === null) return;
        show(state.kind === 'alive' || state.kind === 'failed' ? { ...state, others } : { kind: 'others', others });
      });
    });
  };

  /** A change is over: the search for its last state goes on, and extends the step. */
  const finish = ({ kind, how, start, file }: DocumentEvent) => {
    const step = document.lastStep();
    if (kind !== 'change' || how !== 'edited' || step === null) return;
    const current = chase?.start === start ? chase : null;
    // at once: nothing may come of the search that follows
    const back = replaced.putBack(start, step);
    if (current !== null && back.includes(current.former.name)) current.carried = null;
    if (!settings.getState().keepAlive || isSameGame(start, file)) return;
    rest();
    if (current === null || (!isBroken() && current.carried === null)) {
      finishOthers(start, step);
      return;
    }
    const hear = (answer: Answer) => {
      if (chase !== current || document.lastStep() !== step) return;
      if (document.gesture() !== null) {
        // a click may change nothing; a gesture that does ends the search
        if (answer.isLast) forget = desk.afterRest(REST, () => hear(answer));
        return;
      }
      const isTaken = take(current, answer, step);
      if (!answer.isLast) return;
      if (!isTaken && isBroken()) fail(current, answer.finished, true);
      finishOthers(start, step);
    };
    seeker.ask({ former: current.former, warm: current.warm, effort: EFFORT.last, certifies: true }, hear);
  };

  const stops = [
    proof.store.subscribe(remember),
    document.subscribe(look),
    document.onStep(finish),
    settings.subscribe((now, before) => {
      if (now.keepAlive === before.keepAlive) return;
      stop();
      document.gesture()?.also(null);
    }),
  ];
  remember(proof.proof());
  return () => {
    for (const end of stops) end();
    stop();
    if (isBroken()) document.gesture()?.also(null);
  };
}

// the other runs of the level

/** Ticks that are simulated for each run. */
const EFFORT_OF_OTHERS = 1_000_000;

/** So many runs are kept alive at most. */
const MOST_OTHERS = 4;

interface RescueParts {
  readonly document: EditedLevel;
  readonly proof: ProofStore;
  readonly seeker: HoldSeeker;
  readonly replaced: ReplacedHolds;
}

/**
 * Keeps runs besides the shown one alive that a step has broken, one after the other, and extends the step.
 * @param start the level before the step
 * @param shown the name of the shown run; null if it did not complete the level before
 * @param hear called at the end, unless something else was done since; null: no other run was broken
 */
function rescueOthers(
  { document, proof, seeker, replaced }: RescueParts,
  { start, shown, step }: { readonly start: LevelFile; readonly shown: string | null; readonly step: StepMark },
  hear: (surviving: Surviving | null) => void,
): void {
  const all = othersOf(start, shown, proof.proof());
  const broken = all.filter(({ name }) => !completesNow(proof.proof(), name));
  const names = [...all.map(({ name }) => name), ...(shown === null ? [] : [shown])];
  const next = (i: number) => {
    const former = broken[i];
    if (former === undefined || i === MOST_OTHERS) {
      const complete = names.filter((name) => completesNow(proof.proof(), name)).length;
      hear(broken.length === 0 ? null : { complete, of: names.length });
      return;
    }
    seeker.ask({ former, warm: null, effort: EFFORT_OF_OTHERS, certifies: false }, ({ best, isLast }) => {
      if (!isLast || document.lastStep() !== step) return;
      const holds = best?.holds ?? null;
      if (holds !== null && replayed(proof.proof().scene, joinHolds(holds)) !== null) {
        const { ok } = document.amend(step, replaceHolds(former.name, holds));
        if (ok) replaced.note(start, former.name, holds);
      }
      next(i + 1);
    });
  };
  next(0);
}
