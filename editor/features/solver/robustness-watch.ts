import { createStore, type StoreApi } from 'zustand/vanilla';
import type { EdgeSlack, Robustness, Success } from '../../../solver/index.ts';
import { type Desk, type Question, question } from '../../core/ask/index.ts';
import { type Analysis, type Ghost, type OpenLevel, putGhosts } from '../../core/context/index.ts';
import type { EditedLevel } from '../../core/document/index.ts';
import { plural } from '../../core/figures/index.ts';
import { endInWords, isWhole, type LiveProof, type ProofStore, withoutRuns } from '../../core/proof/index.ts';
import { type AskedOf, FAN_TICKS, type Fan, type FanWay, jobs, type ProgressOf } from '../../workers/index.ts';

/** The robustness of the shown run, as far as it is known. */
export interface RobustnessState {
  /** `fails`: the run does not meet the goal, so there is nothing to measure */
  readonly phase: 'waiting' | 'measuring' | 'measured' | 'fails' | 'failed';
  readonly message: string | null;
  readonly slack: readonly EdgeSlack[] | null;
  /** first a rough estimate, then that of `full` */
  readonly p40: Success | null;
  readonly full: Robustness | null;
  /** Whether the minerals that the run collects are part of the goal. */
  readonly withMinerals: boolean;
}

/** A run of which the robustness is measured. */
interface Measured {
  readonly known: LiveProof;
  /** Whether the minerals that it collects are part of the goal. */
  readonly withMinerals: boolean;
}

/** The run as a worker gets it; null: it does not complete the level. */
function requestOf({ known, withMinerals }: Measured): AskedOf<typeof jobs.fan> | null {
  const { level, terms, run } = known;
  if (run.name === null || run.outcome !== 'completed' || !isWhole(known)) return null;
  return { level: withoutRuns(level), terms, holds: run.holds, goal: { minerals: withMinerals ? run.minerals.length : 'any' } };
}

interface ShownRun {
  readonly proof: ProofStore;
  readonly withMinerals: Pick<StoreApi<boolean>, 'getState' | 'subscribe'>;
}

/** The ways of the shown run when an edge slips. */
export const fanQuestion = question({
  job: jobs.fan,
  request: requestOf,
  follows: {
    wait: { rest: 120 },
    of: ({ proof, withMinerals }: ShownRun): Measured => ({ known: proof.proof(), withMinerals: withMinerals.getState() }),
    // a run that was cut off is simulated to its end once the page is at rest
    same: ({ known: a, ...one }, { known: b, ...other }) =>
      a.scene === b.scene &&
      isWhole(a) === isWhole(b) &&
      a.run.holds.join() === b.run.holds.join() &&
      one.withMinerals === other.withMinerals,
    on: ({ proof, withMinerals }) => [proof.store.subscribe, withMinerals.subscribe],
  },
});

type FanQuestion = Question<Measured, Fan, ProgressOf<typeof jobs.fan>>;

/** The robustness of a run whose fan is known. The fan is what the user looks at: the longer measurement must not slow it down. */
export const robustnessQuestion = question({
  job: jobs.robustness,
  request: requestOf,
  follows: {
    wait: { rest: 0 },
    of(fan: FanQuestion) {
      const { phase, of, gaveUp } = fan.store.getState();
      return phase === 'done' || (phase === 'failed' && !gaveUp) ? of : null;
    },
    same: (asked, now) => asked === now,
    on: (fan) => [fan.store.subscribe],
  },
});

export interface RobustnessWatch {
  readonly store: StoreApi<RobustnessState>;
  setWithMinerals(on: boolean): void;
  close(): void;
}

interface WatchParts {
  readonly level: Pick<OpenLevel, 'proof' | 'analysis' | 'ghosts'> & { readonly document: Pick<EditedLevel, 'onStep'> };
  readonly desk: Desk;
}

const UNKNOWN = { message: null, slack: null, p40: null, full: null } as const;

const toGhost = ({ edge, shift, points }: FanWay): Ghost => ({
  id: `slack-${edge}-${shift}`,
  label: `${edge % 2 === 0 ? 'press' : 'release'} ${(edge >> 1) + 1} ${plural(Math.abs(shift), 'tick')} ${shift < 0 ? 'earlier' : 'later'}`,
  points: everyTick(points, FAN_TICKS),
  look: 'slack',
});

/**
 * Measures the robustness of the shown run again whenever the run or the level has settled, for the timeline, the canvas and
 * the panel.
 */
export function watchRobustness({ level, desk }: WatchParts): RobustnessWatch {
  const { proof, analysis, document } = level;
  const goal = createStore<boolean>(() => false);
  const fan = fanQuestion(desk, { proof, withMinerals: goal });
  const robustness = robustnessQuestion(desk, fan);

  const stateNow = (): RobustnessState => {
    const [spread, measured, withMinerals] = [fan.store.getState(), robustness.store.getState(), goal.getState()];
    const { phase, of, message, gaveUp } = spread;
    const slack = measured.progress?.slack ?? spread.progress?.slack ?? null;
    const sofar = { ...UNKNOWN, slack, p40: measured.progress?.p40 ?? null, withMinerals };
    if (phase === 'nothing' && of !== null && !isWhole(of.known))
      return { ...sofar, phase: 'failed', message: endInWords(of.known) };
    if (phase === 'nothing') return { ...sofar, phase: 'fails' };
    if (phase === 'failed' && gaveUp) return { ...sofar, phase: 'failed', message };
    if (measured.phase === 'failed') return { ...sofar, phase: 'failed', message: measured.message };
    if (measured.answer === null) return { ...sofar, phase: phase === 'waiting' ? 'waiting' : 'measuring' };
    const { answer } = measured;
    return { ...sofar, phase: 'measured', slack: answer.slack, p40: answer.p40, full: answer };
  };
  /** For the timeline; its certification is not known before the end. */
  const analysisNow = (): Analysis | null => {
    const { of, progress, answer } = robustness.store.getState();
    const known = answer ?? progress;
    if (of === null || known === null) return null;
    const { certifiedTicks = null, decided = false } = answer ?? {};
    return { holds: of.known.run.holds.join(), slack: known.slack, certifiedTicks, decided, p40: known.p40.p };
  };

  const store = createStore<RobustnessState>(stateNow);
  let ways: readonly FanWay[] = [];
  const show = () => {
    store.setState(stateNow(), true);
    const analysed = analysisNow();
    if (analysed !== null || analysis.getState() !== null) analysis.setState(analysed, true);
    const fresh = fan.store.getState().answer?.ways ?? [];
    if (fresh === ways || fresh.length + ways.length === 0) return;
    ways = fresh;
    putGhosts(level.ghosts, 'slack', ways.map(toGhost));
  };
  show();
  let forget = () => {};
  const stops = [
    fan.store.subscribe(show),
    robustness.store.subscribe(show),
    document.onStep(() => {
      // Not within the event itself: the frame that shows the change comes first.
      forget();
      forget = desk.after(0, () => {
        const { phase, of } = fan.store.getState();
        if (phase === 'waiting' && of !== null && requestOf(of) !== null) fan.ask(of);
      });
    }),
  ];
  return {
    store,
    setWithMinerals: (on) => goal.setState(on, true),
    close() {
      for (const stop of stops) stop();
      forget();
      robustness.close();
      fan.close();
    },
  };
}

/** A path known at every `ticks` ticks, interpolated linearly to one entry per tick. */
export function everyTick(points: Float32Array, ticks: number): Float32Array {
  const count = points.length / 2;
  if (count < 2) return points;
  const filled = new Float32Array(2 * ((count - 1) * ticks + 1));
  for (let i = 0; i < count - 1; i++) {
    for (let k = 0; k <= ticks; k++) {
      const share = k / ticks;
      const o = 2 * (i * ticks + k);
      filled[o] = points[2 * i] * (1 - share) + points[2 * i + 2] * share;
      filled[o + 1] = points[2 * i + 1] * (1 - share) + points[2 * i + 3] * share;
    }
  }
  return filled;
}
