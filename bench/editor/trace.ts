/** An event of a trace, as Chromium writes it. Times are in us; `tdur` is processor time. */
interface TraceEvent {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  readonly dur?: number;
  readonly tdur?: number;
  readonly args?: { readonly data?: { readonly type?: string } };
}

/** What is traced: tasks of the page's main thread, what they do, and marks that the benchmark sets. */
export const TRACED = ['toplevel', 'devtools.timeline', 'disabled-by-default-devtools.timeline', 'blink.user_timing'];

/** What one action of the person cost, ms. */
export interface Cost {
  /** Processor time of the page's main thread until its work for the next frame was done, without handing the picture over. */
  readonly script: number;
  /** Clock time until the frame was handed over to be painted. */
  readonly frame: number;
}

/** Handing the canvas's picture over: without a graphics card the processor copies it. */
const isHandOver = (name: string): boolean => name === 'Commit';

const endOf = ({ ts, dur = 0 }: TraceEvent): number => ts + dur;

/**
 * The cost of each event of a kind, until the frame that shows its effect was done.
 * @param type - of the DOM event: `pointermove`, `keydown`
 * @param done - name of a mark; the frame after it counts instead of the frame after the event
 */
export function costs(trace: string, type: string, done: string | null = null): Cost[] {
  const { traceEvents } = JSON.parse(trace) as { traceEvents: readonly TraceEvent[] };
  const inputs = traceEvents.filter(({ name, args }) => name === 'EventDispatch' && args?.data?.type === type);
  const main = inputs[0];
  if (main === undefined) throw new Error(`the trace has no ${type}: was the page covered?`);
  const onMain = traceEvents.filter(({ pid, tid }) => pid === main.pid && tid === main.tid).sort((a, b) => a.ts - b.ts);
  const tasks = onMain.filter(({ name, ph }) => name === 'RunTask' && ph === 'X');
  const frames = onMain.filter(({ name, ph }) => isHandOver(name) && ph === 'X');
  const marks = onMain.filter(({ name }) => name === done);
  return inputs.flatMap(({ ts }) => {
    const from = done === null ? ts : marks.find((mark) => mark.ts >= ts)?.ts;
    const frame = from === undefined ? undefined : frames.find((commit) => endOf(commit) >= from);
    if (frame === undefined) return [];
    const end = endOf(frame);
    const within = (event: TraceEvent) => endOf(event) > ts && event.ts < end;
    const sum = (events: readonly TraceEvent[]) => events.filter(within).reduce((total, { tdur = 0 }) => total + tdur, 0);
    return [{ script: (sum(tasks) - sum(frames)) / 1000, frame: (end - ts) / 1000 }];
  });
}
