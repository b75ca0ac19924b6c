import type { ComponentType, ReactNode } from 'react';
import type { CanvasPart } from '../canvas/index.ts';
import type { Command, Destination } from '../core/commands/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import type { LayerSwitch } from '../core/session/index.ts';
import type { TimelinePart } from '../timeline/index.ts';

/**
 * A feature of the page: what it adds, and where. The canvas, the timeline, the panels, the palette and the session know it by
 * the list in `index.ts` alone.
 */
export interface Feature {
  /** The name of its folder. */
  readonly name: string;
  /** Layers of its own that can be shown and hidden. */
  readonly layers?: readonly LayerSwitch[];
  readonly canvas?: CanvasPart;
  readonly timeline?: TimelinePart;
  readonly panel?: Panel;
  /** A part of another feature's panel. */
  readonly section?: { readonly panel: string; readonly content: ComponentType };
  /** In the status bar, before how the shown run ends. */
  readonly status?: ComponentType;
  /** Over the page: its dialogs. Shown whether or not a level is open. */
  readonly dialogs?: ComponentType;
  /** In the middle of the upper edge of the canvas while the level is edited. */
  readonly offer?: ComponentType;
  /** Over the canvas and its tools. */
  readonly screen?: ComponentType;
  /** Rendered while a level is open, whichever panel is in front: it shows nothing and keeps something up to date. */
  readonly watch?: ComponentType;
  /** Commands that are there whatever is shown. */
  readonly commands?: (editor: Editor) => readonly Command[];
  /** Commands that are there while a level is open. */
  readonly levelCommands?: (editor: Editor, level: OpenLevel) => readonly Command[];
  /** Where the palette can go. */
  readonly destinations?: (editor: Editor) => readonly Destination[];
  /** Called as soon as the page is there. @returns ends it */
  readonly start?: (editor: Editor) => () => void;
  /**
   * Called before anything else of the page is made, to take from its address what a reload should not find again.
   * @returns is called once the first level is there
   */
  readonly arrive?: (page: Window) => (editor: Editor) => void;
  /** Opens what the page's address names. @returns whether it names a level that is there */
  readonly openNamed?: (editor: Editor) => Promise<boolean>;
  /** Called when a level is opened, before it is shown. @returns ends it, when another one is opened */
  readonly open?: (editor: Editor, level: OpenLevel) => () => void;
}

/** A panel: a tab on a phone, part of a side on a wide screen. */
export interface Panel {
  readonly id: string;
  readonly title: string;
  readonly icon: ReactNode;
  readonly side: 'left' | 'right';
  /** `tab`: shown one at a time with the other tabs of its side. `fixed`: always shown, above the left tabs or below the right ones. */
  readonly place: 'tab' | 'fixed';
  /** @param sections what other features add to it */
  readonly content: ComponentType<{ readonly sections: readonly ComponentType[] }>;
}
