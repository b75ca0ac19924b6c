import { hasMoved, type PointerInput } from './state.ts';

/** ms that a finger must rest to open the menu */
const LONG = 500;

export interface LongPress {
  begin(input: PointerInput): void;
  /** A finger that moves does something else. */
  move(input: PointerInput): void;
  end(): void;
}

/** Calls back when a finger rests where it was put down. */
export function longPress(call: (input: PointerInput) => void): LongPress {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let from: PointerInput | null = null;
  const end = () => {
    clearTimeout(timer);
    from = null;
  };
  return {
    begin(input) {
      end();
      from = input;
      timer = setTimeout(() => {
        from = null;
        call(input);
      }, LONG);
    },
    move(input) {
      if (from !== null && hasMoved(from, input)) end();
    },
    end,
  };
}
