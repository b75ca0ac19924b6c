import { Pause, Play, Plus, X } from 'lucide-react';
import { useCallback, useEffect, useRef, useState } from 'react';
import { TICK } from '../../../engine/index.ts';
import { useEditor, useLevel, useSession } from '../../core/context/index.ts';
import { keepHolds } from '../../core/levels/index.ts';
import type { Replay } from '../../core/session/index.ts';
import { Button } from '../../core/ui/index.ts';
import { PlayView, SpeedAndMinerals } from './PlayView.tsx';
import { createReplay, type ReplayPlayer } from './playtest.ts';
import { everyFrame } from './use-playtest.ts';

/** The playtest, or the replay of a play. */
export function PlayScreen() {
  const mode = useSession((state) => state.mode);
  const playFrom = useSession((state) => state.playFrom);
  if (mode !== 'play') return null;
  return typeof playFrom === 'string' ? <PlayView /> : <ReplayView replay={playFrom} />;
}

type Moment = Pick<ReplayPlayer, 'tick' | 'minerals' | 'speed' | 'isOver'>;

const momentOf = ({ tick, minerals, speed, isOver }: ReplayPlayer): Moment => ({ tick, minerals, speed, isOver });

/** A replay of an attempt or a play over the canvas: it can be stopped, slowed down and moved along time. */
function ReplayView({ replay }: { readonly replay: Replay }) {
  const editor = useEditor();
  const level = useLevel();
  const host = useRef<HTMLDivElement>(null);
  const player = useRef<ReplayPlayer | null>(null);
  const [isPlaying, setPlaying] = useState(true);
  const [moment, setMoment] = useState<Moment>({ tick: 0, minerals: 0, speed: 0, isOver: false });
  const isPlayingNow = useRef(isPlaying);
  isPlayingNow.current = isPlaying;

  useEffect(() => {
    const { level: played, terms } = level.proof.proof();
    const playing = createReplay(played, terms, replay);
    player.current = playing;
    level.playtest.setState({ pose: () => playing.pose(), moment: () => playing.moment() }, true);
    host.current?.focus({ preventScroll: true });
    const stop = everyFrame(
      () => editor.session.getState().rate,
      (ms) => {
        if (!isPlayingNow.current || playing.isOver) return;
        const { tick } = playing;
        playing.advance(ms);
        if (playing.tick !== tick) setMoment(momentOf(playing));
        if (playing.isOver) setPlaying(false);
      },
    );
    return () => {
      stop();
      player.current = null;
      level.playtest.setState(null, true);
    };
  }, [editor, level, replay]);

  const seek = useCallback((tick: number) => {
    const playing = player.current;
    if (playing === null) return;
    playing.seek(tick);
    setMoment(momentOf(playing));
  }, []);
  const leave = useCallback(() => editor.session.setState({ mode: 'edit' }), [editor]);
  const toggle = useCallback(() => {
    if (player.current?.isOver === true) seek(0);
    setPlaying((before) => !before);
  }, [seek]);
  const keep = useCallback(() => {
    keepHolds({ editor, level }, replay.title, replay.holds);
    leave();
  }, [editor, level, replay, leave]);
  const step = useCallback(
    (by: number) => {
      setPlaying(false);
      seek((player.current?.tick ?? 0) + by);
    },
    [seek],
  );

  useEffect(() => {
    const play = { group: 'Play', mode: 'play' } as const;
    return editor.commands.register([
      { ...play, id: 'play.stop', title: 'Leave the replay', keys: ['Escape'], pad: 'Start', run: leave },
      { ...play, id: 'play.restart', title: 'Replay from the start', keys: ['r', 'Home'], pad: 'Select', run: () => seek(0) },
      { ...play, id: 'replay.pause', title: 'Stop or go on with the replay', keys: ['Space', 'k'], pad: 'A', run: toggle },
      { ...play, id: 'replay.back', title: 'Previous tick of the replay', keys: ['Comma'], pad: 'Left', run: () => step(-1) },
      { ...play, id: 'replay.on', title: 'Next tick of the replay', keys: ['Period'], pad: 'Right', run: () => step(1) },
      { ...play, id: 'replay.keep', title: 'Keep what is replayed as a run', keys: ['Enter'], run: keep },
    ]);
  }, [editor, leave, seek, toggle, step, keep]);

  const { tick, isOver } = moment;
  return (
    <div ref={host} className="play play--replay" tabIndex={-1} role="application" aria-label={`Replay of ${replay.title}`}>
      <div className="play__hud">
        <div className="play__readout numbers" aria-hidden>
          <SpeedAndMinerals {...moment} />
        </div>
      </div>
      <div className={`replay replay--${replay.look}`}>
        <div className="replay__line">
          <strong className="replay__title" title={replay.title}>
            {replay.title}
          </strong>
          <span className="replay__end">{replay.end}</span>
        </div>
        <div className="replay__line">
          <Button
            hint={isPlaying ? 'Stop the replay' : isOver ? 'Replay from the start' : 'Go on with the replay'}
            shortcut="Space"
            icon={isPlaying ? <Pause size={16} /> : <Play size={16} />}
            onClick={toggle}
          />
          <div className="replay__time">
            <HoldStrip replay={replay} />
            <input
              type="range"
              aria-label="Time of the replay"
              aria-valuetext={`tick ${tick} of ${replay.tick}, ${(tick * TICK).toFixed(2)} s`}
              min={0}
              max={replay.tick}
              value={tick}
              onChange={(event) => {
                setPlaying(false);
                seek(event.target.valueAsNumber);
              }}
            />
          </div>
          <span className="replay__moment numbers">
            {(tick * TICK).toFixed(2)} / {(replay.tick * TICK).toFixed(2)} s
          </span>
          <Button hint="Keep it in the level as a run" shortcut="Enter" icon={<Plus size={16} />} onClick={keep} />
          <Button hint="Back to editing" shortcut="Esc" icon={<X size={16} />} onClick={leave} />
        </div>
      </div>
    </div>
  );
}

/** When the gun is held, along the time of the replay. */
function HoldStrip({ replay: { holds, tick } }: { readonly replay: Replay }) {
  const last = Math.max(1, tick);
  return (
    <svg className="replay__holds" viewBox={`0 0 ${last} 1`} preserveAspectRatio="none" aria-hidden>
      <title>The gun</title>
      {holds.map(([press, release]) => (
        <rect key={press} x={press} y={0} width={release - press} height={1} />
      ))}
    </svg>
  );
}
