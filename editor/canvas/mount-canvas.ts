import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import { chooseTool } from '../core/session/index.ts';
import { canvasCommands } from './canvas-commands.ts';
import type { CanvasState } from './canvas-state.ts';
import { paste } from './clipboard-commands.ts';
import { createCrosshair } from './crosshair.ts';
import { extentOf } from './extent.ts';
import { menuEntries } from './menu-entries.ts';
import type { DrawnPart } from './part.ts';
import { pictureOf } from './picture.ts';
import { type LastClick, listenToDrops, listenToPointer, type PointerContext } from './pointer/index.ts';
import { objectChanges } from './selection-changes.ts';
import { type Stage, stageOf } from './stage.ts';
import { fitBox, lookAt, type Point, type View } from './view.ts';

interface MountParts {
  readonly element: HTMLElement;
  readonly editor: Editor;
  readonly level: OpenLevel;
  readonly canvas: StoreApi<CanvasState>;
  /** Announcements of the crosshair. */
  readonly said: StoreApi<string>;
  /** What features of the page draw into the level. */
  readonly drawn: readonly DrawnPart[];
}

/** Shows a level in an element for editing. @returns removes it */
export function mountCanvas({ element, editor, level, canvas, said, drawn }: MountParts): () => void {
  const { settings, session, notices } = editor;
  const { document, selection, hovered } = level;
  const setView = (view: View) => {
    canvas.setState({ view });
    session.setState({ zoom: view.zoom });
  };
  const stage = stageOf(editor, drawn);
  const unmount = stage.mount(element, pictureOf(editor, level, canvas, drawn));
  const { bringIntoView, stop: stopFitting } = fitView({ element, editor, level, canvas, stage, setView });
  const changes = objectChanges(editor, level);
  const context: PointerContext = {
    document,
    her: () => level.proof.proof().scene.box,
    selection,
    canvas,
    hovered,
    view: () => canvas.getState().view,
    setView,
    tool: () => session.getState().tool,
    setTool: (tool) => chooseTool(session, tool),
    snapping: () => {
      const { snapToGrid, grid, snapToObjects } = settings.getState();
      return { grid: snapToGrid ? grid : null, toObjects: snapToObjects };
    },
    isToolLocked: () => session.getState().isToolLocked,
    clicks: createStore<LastClick | null>(() => null),
    openMenu(place, screen) {
      const pasteAt = (at: Point) => void paste(editor, changes, canvas.getState().view, at);
      canvas.setState({ menu: { screen, parts: menuEntries({ editor, level, context, changes, pasteAt }, place) } });
    },
    measure: (measures) => canvas.setState({ measures }),
    say: (words, at) => canvas.setState({ message: { words, at } }),
    refused: (message) => notices.show('warning', message, { topic: 'refused' }),
  };
  const pointer = listenToPointer(element, context, () => session.getState().mode === 'edit');
  const stopDrops = listenToDrops(element, context);
  const crosshair = createCrosshair({ element, context, pointer, grid: () => settings.getState().grid, said });
  const forget = editor.commands.register(
    canvasCommands({ editor, level, canvas, context, changes, setView, bringIntoView, pointer, crosshair }),
  );
  return () => {
    forget();
    stopDrops();
    crosshair.stop();
    pointer.stop();
    stopFitting();
    unmount();
  };
}

interface FitParts {
  readonly element: HTMLElement;
  readonly editor: Editor;
  readonly level: OpenLevel;
  readonly canvas: StoreApi<CanvasState>;
  readonly stage: Stage;
  readonly setView: (view: View) => void;
}

interface Fitting {
  /** @param keys of objects; the whole level if absent */
  readonly bringIntoView: (keys?: readonly string[]) => void;
  readonly stop: () => void;
}

/**
 * Keeps the view at the size of the element, and the whole level in view until the user moves the view; then looks at the place
 * that the session asks for.
 */
function fitView({ element, editor: { session, open }, level, canvas, stage, setView }: FitParts): Fitting {
  // the view that shows the whole level, while the user has not moved it
  let fitted: View | null = null;
  const bringIntoView = (keys?: readonly string[]) => {
    const box = extentOf(level.document.file(), level.proof.proof().scene.box, keys);
    if (box === null) return;
    setView(fitBox(canvas.getState().view, box));
    if (keys === undefined) fitted = canvas.getState().view;
  };
  let isShown = false;
  const look = () => {
    const place = session.getState().lookAt;
    // the canvas of the last level may still be there
    if (place === null || !isShown || open.getState() !== level) return;
    session.setState({ lookAt: null });
    setView(lookAt(canvas.getState().view, place));
  };
  const stopLooking = session.subscribe(look);
  const observer = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = element;
    stage.resize(width, height);
    const { view } = canvas.getState();
    setView({ ...view, width, height });
    // A view that shows the whole level continues to do so when the page is rotated or a panel opens.
    if (width > 1 && (!isShown || view === fitted)) bringIntoView();
    isShown ||= width > 1;
    look();
  });
  observer.observe(element);
  const stop = () => {
    observer.disconnect();
    stopLooking();
  };
  return { bringIntoView, stop };
}
