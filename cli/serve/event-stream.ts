import { EDIT_API, type EditEvent, type LevelEntry } from '../../schema/index.ts';
import type { KnownLevels } from './known-levels.ts';
import { Refusal } from './refusal.ts';

/** The largest number of pages that listen at the same time. */
const MAX_STREAMS = 32;

/** The number of bytes that may be sent before the page reads them. */
const AHEAD = 1024 * 1024;

/** The largest number of events that wait for a page. Then its stream is closed; a page that reconnects gets the whole list. */
const MAX_WAITING = 10_000;

/** The largest number of levels in one event. */
const TOGETHER = 1000;

/** Divides an event into parts that are small enough to send: a `list` event, then `read` events with the other levels. */
export function* inParts(event: EditEvent): Generator<EditEvent> {
  if (event.type !== 'list' || event.list.levels.length <= TOGETHER) {
    yield event;
    return;
  }
  const { levels, unread } = event.list;
  const part = (from: number): LevelEntry[] => levels.slice(from, from + TOGETHER);
  const after = (from: number): number => unread + Math.max(0, levels.length - from - TOGETHER);
  yield { type: 'list', list: { ...event.list, levels: part(0), unread: after(0) } };
  for (let from = TOGETHER; from < levels.length; from += TOGETHER) {
    yield { type: 'read', levels: part(from), unread: after(from) };
  }
}

/** Streams of the events of a folder, one for each page. */
export function createEventStreams(known: KnownLevels): { open(): ReadableStream<Uint8Array> } {
  let count = 0;
  const open = (): ReadableStream<Uint8Array> => {
    if (count >= MAX_STREAMS) throw new Refusal('busy', `${MAX_STREAMS} pages are already connected`, 'Close some of the tabs.');
    count++;
    const encoder = new TextEncoder();
    let waiting: EditEvent[] = [...inParts({ type: 'list', list: known.list() })];
    let isOver = false;
    let leave = (): void => {};
    const stop = (): void => {
      if (isOver) return;
      isOver = true;
      waiting = [];
      leave();
      count--;
    };
    const sendSome = (controller: ReadableStreamDefaultController<Uint8Array>): void => {
      while (!isOver && waiting.length > 0 && (controller.desiredSize ?? 0) > 0) {
        controller.enqueue(encoder.encode(`data: ${JSON.stringify(waiting.shift())}\n\n`));
      }
    };
    return new ReadableStream<Uint8Array>(
      {
        start(controller) {
          const beat = setInterval(() => {
            // while data waits to be read, no heartbeat is needed
            if (!isOver && (controller.desiredSize ?? 0) > 0) controller.enqueue(encoder.encode(': still here\n\n'));
          }, EDIT_API.HEARTBEAT * 1000);
          const stopListening = known.listen((event) => {
            // a new list replaces all earlier events
            if (event.type === 'list') waiting = [];
            waiting.push(...inParts(event));
            sendSome(controller);
            if (isOver || waiting.length <= MAX_WAITING) return;
            stop();
            controller.close();
          });
          leave = () => {
            clearInterval(beat);
            stopListening();
          };
          sendSome(controller);
        },
        pull: sendSome,
        cancel: stop,
      },
      new ByteLengthQueuingStrategy({ highWaterMark: AHEAD }),
    );
  };
  return { open };
}
