import { EDIT_API } from '../../schema/index.ts';
import type { KnownLevels } from './known-levels.ts';
import { Refusal } from './refusal.ts';

/** Pages that listen at a time. */
const MAX_STREAMS = 32;

/** Bytes that wait for a page that sleeps; then it is let go, and hears the whole list when it comes back. */
const MAX_WAITING = 16 * 1024 * 1024;

/** Streams of what goes on in a folder, one a page. */
export function createEventStreams(known: KnownLevels): { open(): ReadableStream<Uint8Array> } {
  let count = 0;
  const open = (): ReadableStream<Uint8Array> => {
    if (count >= MAX_STREAMS) throw new Refusal('busy', `${MAX_STREAMS} pages listen already`, 'Close some of the tabs.');
    count++;
    let stop = (): void => {};
    return new ReadableStream<Uint8Array>(
      {
        start(controller) {
          const encoder = new TextEncoder();
          const send = (text: string): void => {
            controller.enqueue(encoder.encode(text));
            if ((controller.desiredSize ?? 0) > 0) return;
            stop();
            controller.close();
          };
          const beat = setInterval(() => send(': still here\n\n'), EDIT_API.HEARTBEAT * 1000);
          let hush = (): void => {};
          stop = () => {
            stop = () => {};
            clearInterval(beat);
            hush();
            count--;
          };
          hush = known.listen((event) => send(`data: ${JSON.stringify(event)}\n\n`));
        },
        cancel: () => stop(),
      },
      new ByteLengthQueuingStrategy({ highWaterMark: MAX_WAITING }),
    );
  };
  return { open };
}
