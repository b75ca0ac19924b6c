import type { Scene } from 'phaser';
import type { ComponentType, RefObject } from 'react';
import type { StoreApi } from 'zustand';
import type { Box } from '../../engine/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import type { CanvasState } from './canvas-state.ts';
import type { Theme } from './colours.ts';

/** What a feature of the page shows on the canvas. The canvas is handed the parts of all features, and knows none by name. */
export interface CanvasPart {
  /** Drawn into the level. */
  readonly drawn?: DrawnPart;
  /** Over the level and below everything else: shades, labels at places. */
  readonly labels?: ComponentType<OnCanvas>;
  /** Among the legends in a corner. */
  readonly legend?: ComponentType;
  /** Above everything else: what is shown beside the pointer or beside objects. */
  readonly cards?: ComponentType<OnCanvas>;
}

/** A part with the name of its feature. */
export interface NamedPart extends CanvasPart {
  readonly name: string;
}

/** What a component on the canvas is given. */
export interface OnCanvas {
  readonly canvas: StoreApi<CanvasState>;
  /** The element of the canvas. */
  readonly host: RefObject<HTMLElement | null>;
}

/** Something that is drawn into the level, from a picture of it. */
export interface DrawnPart<T = unknown> {
  /** What is shown of an open level, read once per frame: the same object until something of it changes. */
  readonly pictureOf: (editor: Editor, level: OpenLevel) => () => T;
  /** Called again for another theme. The depths of what it adds say what it covers; `setDepth` in `layers/` has the others. */
  readonly draw: (scene: Scene, theme: Theme) => Drawing<T>;
}

export interface Drawing<T> {
  /** Called when the picture, the zoom or her box is another one. */
  show(picture: T, frame: Frame): void;
  destroy(): void;
}

export interface Frame {
  /** px of screen per px of the level */
  readonly zoom: number;
  /** Her collision box under the rules of the level; the same object while its size stays. */
  readonly her: Box;
}

/** Makes a picture anew only when one of its parts is another one. @param parts what the picture is made of */
export function unchanged<P extends readonly unknown[], T>(parts: () => P, make: (parts: P) => T): () => T {
  let made: { readonly of: P; readonly picture: T } | null = null;
  return () => {
    const of = parts();
    if (made === null || of.some((part, i) => part !== made?.of[i])) made = { of, picture: make(of) };
    return made.picture;
  };
}
