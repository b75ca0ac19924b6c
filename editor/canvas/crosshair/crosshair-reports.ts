import type { StoreApi } from 'zustand/vanilla';
import type { LevelFile } from '../../../schema/index.ts';
import type { ObjectKey } from '../../core/document/index.ts';
import type { PointerContext } from '../pointer/index.ts';
import type { Point } from '../view.ts';
import { lockedUnder, under } from './crosshair-place.ts';
import { changeInWords, passedByInWords, placeInWords, selectionInWords, thingInWords } from './words.ts';

/** The level and the selection at one moment. */
export interface Moment {
  readonly file: LevelFile;
  readonly keys: readonly ObjectKey[];
}

/** Announces what the crosshair does, for screen readers. */
export class CrosshairReports {
  /** Whether a held key moves the crosshair: its position is announced when the key is released. */
  isPending = false;

  constructor(
    private readonly context: PointerContext,
    private readonly said: StoreApi<string>,
  ) {}

  report(text: string): void {
    this.isPending = false;
    this.said.setState(text, true);
  }

  /** What lies at a point, in words. */
  thing(place: Point): string {
    const { document, selection } = this.context;
    const hit = under(this.context, place);
    return hit === null
      ? passedByInWords(lockedUnder(this.context, place))
      : thingInWords(document.file(), hit, selection.keys());
  }

  /** @param why announced first */
  reportPlace(place: Point, why: string): void {
    this.report(`${why}. ${placeInWords(place)}, ${this.thing(place)}`);
  }

  /** Announces where the crosshair is, and what is there or what the drag has done. @param held null: no drag */
  reportStep(place: Point, held: Moment | null): void {
    const { document, selection, canvas } = this.context;
    const here = placeInWords(place);
    if (held === null) this.report(`${here}, ${this.thing(place)}`);
    else if (canvas.getState().marquee !== null) this.report(`${here}, ${selection.keys().length} selected`);
    else this.report(changeInWords(held.file, document.file()) ?? here);
  }

  /** Announces what has changed since a moment. */
  reportDone(place: Point, { file, keys }: Moment): void {
    const { document, selection } = this.context;
    const now = document.file();
    this.report(changeInWords(file, now) ?? `${selectionInWords(now, keys, selection.keys())}. ${placeInWords(place)}`);
  }
}
