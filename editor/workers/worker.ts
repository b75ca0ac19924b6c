import { createRunner } from './runner.ts';
import type { FromWorker, ToWorker } from './workers.ts';

// a message to itself is received after earlier messages, and sooner than a timer fires
const turn = new MessageChannel();
const calls: (() => void)[] = [];
turn.port1.onmessage = () => calls.shift()?.();

const hear = createRunner({
  post: (message: FromWorker) => postMessage(message),
  later(call) {
    calls.push(call);
    turn.port2.postMessage(null);
  },
  now: () => performance.now(),
});
addEventListener('message', ({ data }: MessageEvent<ToWorker>) => hear(data));
