import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Scene } from '../../../engine/index.ts';
import type { EdgeSlack, Goal, Robustness, Success } from '../../../solver/index.ts';
import type { Ghost } from '../../core/context/index.ts';
import type { EditedLevel } from '../../core/document/index.ts';
import { plural } from '../../core/figures/index.ts';
import { endInWords, isWhole, type ProofStore } from '../../core/proof/index.ts';
import { FAN_TICKS, type FanWay, type Job, type Workers } from '../../workers/index.ts';
import { type GhostShelf, putGhosts } from './ghost-shelf.ts';
import { everyTick } from './ways.ts';
import { withoutRuns } from './without-runs.ts';

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

/** The part that the timeline and the canvas show. */
interface Analysed {
  /** The holds it belongs to, joined by commas. */
  readonly holds: string;
  readonly slack: readonly EdgeSlack[];
  /** All shifts of all edges by up to this many ticks succeed; null while this is being certified. */
  readonly certifiedTicks: number | null;
  /** Whether some shift by one tick more is known to fail; false if there were too many to check. */
  readonly decided: boolean;
  /** Success with timing noise of 40 ms, 0 to 1. */
  readonly p40: number;
}

export interface RobustnessWatch {
  readonly store: StoreApi<RobustnessState>;
  setWithMinerals(on: boolean): void;
  close(): void;
}

interface WatchParts {
  readonly level: GhostShelf & {
    readonly document: Pick<EditedLevel, 'onStep'>;
    readonly proof: ProofStore;
    readonly analysis: StoreApi<Analysed | null>;
  };
  readonly workers: Pick<Workers, 'start'>;
  /** Calls back after `ms`. @returns cancels it */
  readonly after: (ms: number, call: () => void) => () => void;
  /** Calls back once the page has been at rest for `ms`. @returns cancels it */
  readonly afterRest: (ms: number, call: () => void) => () => void;
}

/** ms without a change before everything is measured; the fan comes as soon as a gesture ends */
const SETTLE = 120;

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
export function watchRobustness({ level, workers, after, afterRest }: WatchParts): RobustnessWatch {
  const { proof, analysis } = level;
  const store = createStore<RobustnessState>(() => ({ phase: 'waiting', ...UNKNOWN, withMinerals: false }));
  let jobs: readonly Job<'fan' | 'robustness'>[] = [];
  let last: { scene: Scene; holds: string; whole: boolean } | null = null;
  let waiting: (() => void)[] = [];

  const put = (analysed: Analysed | null) => {
    if (analysed !== null || analysis.getState() !== null) analysis.setState(analysed, true);
  };
  const drop = () => {
    for (const job of jobs) job.cancel();
    jobs = [];
    for (const forget of waiting) forget();
    waiting = [];
  };
  const isCurrent = (job: Job<'fan' | 'robustness'>) => jobs.includes(job);
  /** The request to the workers; null if there is nothing to measure. */
  const request = () => {
    const { level: played, terms, run } = proof.proof();
    if (run.name === null || run.outcome !== 'completed') return null;
    const goal: Goal = { minerals: store.getState().withMinerals ? run.minerals.length : 'any' };
    return { level: withoutRuns(played), terms, holds: run.holds, goal };
  };

  let fan: Job<'fan'> | null = null;
  const spread = () => {
    const asked = request();
    if (asked === null || jobs.length > 0) return;
    store.setState({ phase: 'measuring' });
    const mine = workers.start('fan', asked, ({ slack }) => {
      if (isCurrent(mine)) store.setState({ slack });
    });
    fan = mine;
    jobs = [mine];
    void mine.end.then((end) => {
      if (isCurrent(mine) && end.kind === 'done') putGhosts(level, 'slack', end.result.ways.map(toGhost));
    });
  };
  const measure = () => {
    const known = proof.proof();
    if (!isWhole(known)) {
      store.setState({ phase: 'failed', ...UNKNOWN, message: endInWords(known) });
      return;
    }
    const asked = request();
    if (asked === null) {
      store.setState({ phase: 'fails', ...UNKNOWN });
      return;
    }
    spread();
    const first = fan;
    const key = asked.holds.join();
    // The fan is what the user looks at: the longer measurement must not slow it down.
    void first?.end.then((end) => {
      if (!isCurrent(first)) return;
      if (end.kind === 'gaveUp') {
        store.setState({ phase: 'failed', message: end.message });
        return;
      }
      const robustness = workers.start('robustness', asked, ({ slack, p40 }) => {
        if (!isCurrent(robustness)) return;
        store.setState({ slack, p40 });
        put({ holds: key, slack, certifiedTicks: null, decided: false, p40: p40.p });
      });
      jobs = [first, robustness];
      void robustness.end.then((end) => {
        if (!isCurrent(robustness)) return;
        if (end.kind === 'failed' || end.kind === 'gaveUp') store.setState({ phase: 'failed', message: end.message });
        if (end.kind !== 'done') return;
        const { slack, p40, certifiedTicks, decided } = end.result;
        store.setState({ phase: 'measured', slack, p40, full: end.result });
        put({ holds: key, slack, certifiedTicks, decided, p40: p40.p });
      });
    });
  };

  const settle = () => {
    drop();
    put(null);
    putGhosts(level, 'slack', []);
    store.setState({ phase: 'waiting', ...UNKNOWN });
    waiting = [afterRest(SETTLE, measure)];
  };
  const look = () => {
    const known = proof.proof();
    const { scene, run } = known;
    const holds = run.holds.join();
    // a run that was cut off is simulated to its end once the page is at rest
    const whole = isWhole(known);
    if (last !== null && last.scene === scene && last.holds === holds && last.whole === whole) return;
    last = { scene, holds, whole };
    settle();
  };
  look();
  const stops = [
    proof.store.subscribe(look),
    level.document.onStep(() => {
      // Not within the event itself: the frame that shows the change comes first.
      if (jobs.length === 0) waiting.push(after(0, spread));
    }),
  ];
  return {
    store,
    setWithMinerals(withMinerals) {
      if (store.getState().withMinerals === withMinerals) return;
      store.setState({ withMinerals });
      settle();
    },
    close() {
      for (const stop of stops) stop();
      drop();
    },
  };
}
