import { useCallback, useEffect, useLayoutEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { useInPace } from '../core/ask/index.ts';
import { useEditor, useLevel, useProof, useSession, useTouch } from '../core/context/index.ts';
import type { LiveProof, Reach } from '../core/proof/index.ts';
import { EventMarks } from './EventMarks.tsx';
import { Graphs } from './Graphs.tsx';
import { GunLane } from './GunLane.tsx';
import { reachedBy } from './holds.ts';
import { NoteFlags, type WrittenNote } from './NoteFlags.tsx';
import { type NamedPart, useBeside } from './part.ts';
import { Ruler } from './Ruler.tsx';
import { followPlayback, runCommands } from './run-commands.ts';
import { fitTicks, panScale, type Scale, toTick, toX, zoomScale } from './scale.ts';
import { Transport } from './Transport.tsx';
import './timeline.css';

/** zoom factor per px of wheel */
const WHEEL_ZOOM = 1.0015;
/** height in px of the key above the graphs */
const KEY_HEIGHT = 16;
/** zoom factor per press of a button or key */
const STEP_ZOOM = 1.5;

const endOf = ({ run }: LiveProof): number => Math.max(1, run.way.count - 1);
const ticksOf = ({ ticks }: Reach): number => ticks;

/** The parts that take longest to compute; they may lag a frame or two behind the pointer. */
const detailsOf = (proof: LiveProof) => ({ events: proof.full?.events ?? [], margins: proof.margins });

/** The shown moment, and the one under the pointer. */
function Cursors({ scale, end }: { readonly scale: Scale; readonly end: number }) {
  const tick = useSession((state) => state.tick);
  const hoverTick = useSession((state) => state.hoverTick);
  return (
    <>
      {hoverTick !== null && <div className="timeline__hover" style={{ left: toX(scale, hoverTick) }} aria-hidden />}
      <div className="timeline__tick" style={{ left: toX(scale, Math.min(tick, end)) }} aria-hidden />
    </>
  );
}

/** Shown instead of the gun lane in a level without runs. */
function NoRun() {
  const touch = useTouch();
  return (
    <div className="lane lane--empty">
      {touch
        ? 'No run yet. Play and keep an attempt as a run, or let the solver find one.'
        : 'No run yet. Press Space to play and keep an attempt as a run, let the solver find one, or press I to add a hold here.'}
    </div>
  );
}

/**
 * The shown run along time: transport, gun lane, events, speed and clearance.
 * @param parts what features of the page show in it; the same list at every call
 */
export function Timeline({ parts }: { readonly parts: readonly NamedPart[] }) {
  const editor = useEditor();
  const level = useLevel();
  const { session, commands } = editor;
  const name = useProof(({ run }) => run.name);
  const holds = useProof(({ run }) => run.holds);
  const end = useProof(endOf);
  const until = useProof((proof) => reachedBy(proof).until);
  const isBroken = useProof((proof) => reachedBy(proof).isBroken);
  const reached = useMemo(() => ({ until, isBroken }), [until, isBroken]);
  const ticks = useStore(level.proof.reach, ticksOf);
  const details = useInPace(level.proof.store, detailsOf, 'idle');
  const drawnTicks = useInPace(level.proof.reach, ticksOf, 'idle');
  const analysis = useStore(level.analysis);
  const box = useRef<HTMLDivElement>(null);
  const graphs = useRef<HTMLDivElement>(null);
  const [size, setSize] = useState({ width: 600, height: 60 });
  // null: the whole run, however long it is
  const [chosen, setChosen] = useState<Scale | null>(null);
  // set while a hold is dragged, which may change where the run ends
  const [kept, setKept] = useState<Scale | null>(null);
  const [isExplained, setExplained] = useState(false);
  const [written, setWritten] = useState<WrittenNote | null>(null);
  const { width } = size;
  // another run may last longer than the shown one
  const { ticks: longest, apart } = useBeside(parts);
  const last = Math.max(end, longest);
  const shown = Math.max(ticks, longest);
  const shownIdle = Math.max(drawnTicks, longest);
  const scale = useMemo(() => chosen ?? kept ?? fitTicks(shown, width), [chosen, kept, shown, width]);
  const drawn = useMemo(() => chosen ?? kept ?? fitTicks(shownIdle, width), [chosen, kept, shownIdle, width]);
  const now = useRef({ scale, end, last, width });
  now.current = { scale, end, last, width };

  useLayoutEffect(() => {
    const [element, plot] = [box.current, graphs.current];
    if (element === null || plot === null) return;
    const observer = new ResizeObserver(() => setSize({ width: element.clientWidth, height: plot.clientHeight }));
    observer.observe(element);
    observer.observe(plot);
    const onWheel = (event: WheelEvent) => {
      event.preventDefault();
      const x = event.clientX - element.getBoundingClientRect().left;
      const { scale: last } = now.current;
      const sideways = event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY);
      setChosen(sideways ? panScale(last, -(event.deltaX + event.deltaY)) : zoomScale(last, x, WHEEL_ZOOM ** -event.deltaY));
    };
    // React's own wheel listeners can't keep the page from scrolling.
    element.addEventListener('wheel', onWheel, { passive: false });
    return () => {
      observer.disconnect();
      element.removeEventListener('wheel', onWheel);
    };
  }, []);
  useEffect(() => followPlayback(session, () => now.current.last), [session]);
  useEffect(() => {
    const run = { end: () => now.current.end, last: () => now.current.last };
    // the shown moment stays in place
    const zoomBy = (factor: number) => {
      const { scale: last, width: room } = now.current;
      const x = toX(last, session.getState().tick);
      setChosen(zoomScale(last, x >= 0 && x <= room ? x : room / 2, factor));
    };
    const forget = commands.register([
      ...runCommands(editor, level, { ...run, writeNote: (tick) => setWritten({ tick, index: null }) }),
      { id: 'run.fit', title: 'Fit the run in the timeline', group: 'Run', run: () => setChosen(null) },
      { id: 'run.zoom-in', title: 'Zoom the timeline in', group: 'Run', run: () => zoomBy(STEP_ZOOM) },
      { id: 'run.zoom-out', title: 'Zoom the timeline out', group: 'Run', run: () => zoomBy(1 / STEP_ZOOM) },
      { id: 'run.legend', title: 'Show the timeline legend', group: 'Help', run: () => setExplained(true) },
    ]);
    return forget;
  }, [commands, editor, level, session]);

  const onDragging = useCallback((isDragging: boolean) => setKept(isDragging ? now.current.scale : null), []);
  const slack = analysis !== null && analysis.holds === holds.join() ? analysis.slack : null;
  const ending = toX(scale, end);
  const isPlaying = useSession(({ mode }) => mode === 'play');
  const isRunShown = useStore(editor.settings, ({ runInPlay }) => runInPlay);
  // the timeline would also give away when to press
  const isHidden = isPlaying && !isRunShown;
  return (
    <div className="timeline">
      <Transport parts={parts} end={end} reached={reached} isExplained={isExplained} onExplain={setExplained} />
      <div
        ref={box}
        className={isHidden ? 'timeline__box timeline__box--hidden' : 'timeline__box'}
        onPointerMove={(event) => {
          if (event.buttons !== 0 || event.pointerType === 'touch') return;
          const at = toTick(scale, event.clientX - event.currentTarget.getBoundingClientRect().left);
          session.setState({ hoverTick: at >= 0 && at <= last ? at : null });
        }}
        onPointerLeave={() => session.setState({ hoverTick: null })}
      >
        {isHidden && <p className="timeline__hidden">Hidden while you play: it would give the run away.</p>}
        <Ruler scale={scale} width={width} end={last} />
        {name !== null && <NoteFlags run={name} scale={scale} width={width} written={written} onWrite={setWritten} />}
        {isBroken && ending < width && (
          <div className="timeline__after" style={{ left: Math.max(0, ending) }} aria-hidden>
            <span className="timeline__unreached">not reached</span>
          </div>
        )}
        {name === null ? (
          <NoRun />
        ) : (
          <GunLane run={name} holds={holds} reached={reached} scale={scale} slack={slack} onDragging={onDragging} />
        )}
        {parts.map(({ name: part, lanes: Lanes }) => Lanes && <Lanes key={part} scale={scale} width={width} end={end} />)}
        <EventMarks events={details.events} scale={drawn} width={width} />
        <div ref={graphs} className="timeline__graphs">
          <Graphs
            margins={details.margins}
            scale={drawn}
            width={width}
            height={Math.max(24, size.height - KEY_HEIGHT)}
            apart={apart}
          />
        </div>
        {parts.map(({ name: part, marks: Marks }) => Marks && <Marks key={part} scale={scale} width={width} end={end} />)}
        <div className="timeline__end" style={{ left: ending }} aria-hidden />
        <Cursors scale={scale} end={last} />
      </div>
    </div>
  );
}
