import type { StoreApi } from 'zustand/vanilla';
import type { LevelFile } from '../../../schema/index.ts';
import type { ObjectKey } from '../../document/index.ts';
import type { PointerContext } from '../pointer/index.ts';
import type { Point } from '../view.ts';
import { under } from './crosshair-place.ts';
import { changeInWords, placeInWords, selectionInWords, thingInWords } from './words.ts';

/** The level and the selection at a moment. */
export interface Moment {
  readonly file: LevelFile;
  readonly keys: readonly ObjectKey[];
}

/** What the crosshair reports to who can't see it. */
export class CrosshairReports {
  /** A key is held that moves it: where it is is reported once that is let go. */
  isPending = false;

  constructor(
    private readonly context: PointerContext,
    private readonly said: StoreApi<string>,
  ) {}

  report(text: string): void {
    this.isPending = false;
    this.said.setState(text, true);
  }

  /** What lies at a place, in words. */
  thing(place: Point): string {
    const { document, selection } = this.context;
    return thingInWords(document.file(), under(this.context, place), selection.keys());
  }

  /** @param why said first */
  reportPlace(place: Point, why: string): void {
    this.report(`${why}. ${placeInWords(place)}, ${this.thing(place)}`);
  }

  /** Where it is, what is there, or what that does to what it holds. @param held null: it holds nothing */
  reportStep(place: Point, held: Moment | null): void {
    const { document, selection, canvas } = this.context;
    const here = placeInWords(place);
    if (held === null) this.report(`${here}, ${this.thing(place)}`);
    else if (canvas.getState().marquee !== null) this.report(`${here}, ${selection.keys().length} selected`);
    else this.report(changeInWords(held.file, document.file()) ?? here);
  }

  /** What has come of something since a moment. */
  reportDone(place: Point, { file, keys }: Moment): void {
    const { document, selection } = this.context;
    const now = document.file();
    this.report(changeInWords(file, now) ?? `${selectionInWords(now, keys, selection.keys())}. ${placeInWords(place)}`);
  }
}
