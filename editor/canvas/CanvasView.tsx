import { useEffect, useRef } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { createStore } from 'zustand/vanilla';
import { useEditor, useLevel } from '../context/index.ts';
import { canvasCommands } from './canvas-commands.ts';
import { createCanvasState } from './canvas-state.ts';
import { EndReason } from './EndReason.tsx';
import './canvas.css';
import type { Pose } from '../context/index.ts';
import { CROSSHAIR_HELP, createCrosshair } from './crosshair/index.ts';
import { extentOf } from './extent.ts';
import type { SearchPicture } from './layers/index.ts';
import { stageOf } from './page-stage.ts';
import { listenToDrops, listenToPointer, type PointerContext } from './pointer/index.ts';
import { poseAt } from './run-pose.ts';
import type { Picture } from './stage.ts';
import { fitBox, type View } from './view.ts';

interface CanvasViewProps {
  /** What searches have to show; followed. */
  readonly search: Pick<StoreApi<SearchPicture>, 'getState'>;
}

/** The level as it looks, to be edited by hand. */
export function CanvasView({ search }: CanvasViewProps) {
  const editor = useEditor();
  const level = useLevel();
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef(createCanvasState()).current;
  const cursor = useStore(canvas, (state) => state.cursor);
  const hasCrosshair = useStore(canvas, (state) => state.crosshair !== null);
  const said = useRef(createStore<string>(() => '')).current;
  const words = useStore(said);

  useEffect(() => {
    const element = host.current;
    if (element === null) return;
    const { settings, session, notices } = editor;
    const { document, selection, hovered, proof, ghosts, playtest } = level;

    const setView = (view: View) => {
      canvas.setState({ view });
      session.setState({ zoom: view.zoom });
    };
    // the view that shows all of the level, until somebody moves it
    let fitted: View | null = null;
    const bringIntoView = (keys?: readonly string[]) => {
      const box = extentOf(document.file(), keys);
      if (box === null) return;
      setView(fitBox(canvas.getState().view, box));
      if (keys === undefined) fitted = canvas.getState().view;
    };

    // the pose of a tick is made once, however many frames show it
    let posed: { proof: object; tick: number; pose: Pose } | null = null;
    const pose = (): Pose => {
      const playing = playtest.getState();
      if (playing !== null) return playing.pose();
      const { tick, hoverTick } = session.getState();
      const at = hoverTick ?? tick;
      const now = proof.proof();
      if (posed === null || posed.proof !== now || posed.tick !== at) posed = { proof: now, tick: at, pose: poseAt(now, at) };
      return posed.pose;
    };
    const picture = (): Picture => {
      const { snapToGrid, grid } = settings.getState();
      const { dataset } = window.document.documentElement;
      return {
        file: document.file(),
        proof: proof.proof(),
        canvas: canvas.getState(),
        selected: selection.keys(),
        hovered: hovered.getState(),
        layers: session.getState().layers,
        grid: snapToGrid ? grid : null,
        ghosts: ghosts.getState(),
        search: search.getState(),
        pose: pose(),
        editing: session.getState().mode === 'edit',
        showsRun: session.getState().mode === 'edit' || settings.getState().runInPlay,
        theme: dataset.theme === 'light' ? 'light' : 'dark',
        calm: dataset.motion === 'less',
      };
    };
    const stage = stageOf(editor);
    const unmount = stage.mount(element, picture);

    let isShown = false;
    const observer = new ResizeObserver(() => {
      const { clientWidth: width, clientHeight: height } = element;
      stage.resize(width, height);
      const { view } = canvas.getState();
      setView({ ...view, width, height });
      // who sees all of the level goes on to do so when the page is turned or a panel opens
      if (width > 1 && (!isShown || view === fitted)) bringIntoView();
      isShown ||= width > 1;
    });
    observer.observe(element);

    const context: PointerContext = {
      document,
      selection,
      canvas,
      hovered,
      view: () => canvas.getState().view,
      setView,
      tool: () => session.getState().tool,
      setTool: (tool) => session.setState({ tool }),
      snapping: () => {
        const { snapToGrid, grid, snapToObjects } = settings.getState();
        return { grid: snapToGrid ? grid : null, toObjects: snapToObjects };
      },
      refused: (message) => notices.show('warning', message, { topic: 'refused' }),
    };
    const pointer = listenToPointer(element, context, () => session.getState().mode === 'edit');
    const stopDrops = listenToDrops(element, context);
    const crosshair = createCrosshair({ element, context, pointer, grid: () => settings.getState().grid, said });
    const forget = editor.commands.register(
      canvasCommands({ editor, level, canvas, setView, bringIntoView, pointer, crosshair }),
    );
    return () => {
      forget();
      stopDrops();
      crosshair.stop();
      pointer.stop();
      observer.disconnect();
      unmount();
    };
  }, [editor, level, canvas, said, search]);

  return (
    <>
      <div
        ref={host}
        className="canvas"
        style={{ cursor }}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: keys use the tools and move what is selected
        tabIndex={0}
        role="application"
        aria-label="Level canvas"
        aria-description={CROSSHAIR_HELP}
      />
      <p className={`canvas__said${hasCrosshair ? '' : ' canvas__said--unseen'} numbers`} role="status" aria-label="Crosshair">
        {words}
      </p>
      <EndReason canvas={canvas} />
    </>
  );
}
