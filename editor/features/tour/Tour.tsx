import { useEffect, useLayoutEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor, useSession } from '../../core/context/index.ts';
import { Button, useCoarse } from '../../core/ui/index.ts';
import { TOUR } from './tour-steps.ts';

interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** px; the height is measured once the text is rendered, this is the initial value */
const CARD = { width: 320, height: 170 } as const;
/** px between a place and the card beside it, and between the card and the edge of the page */
const GAP = 14;

/** The box of the first selector that matches something visible; null: none. */
function find(selectors: readonly string[]): Box | null {
  for (const selector of selectors) {
    const element = document.querySelector(selector);
    const box = element?.getBoundingClientRect();
    if (box !== undefined && box.width > 0) return { left: box.left, top: box.top, width: box.width, height: box.height };
  }
  return null;
}

/** Places the card where there is room beside the box: below, above, right or left of it, or else within it. */
function placeCard(box: Box | null, cardHeight: number): { left: number; top: number } {
  const [width, height] = [window.innerWidth, window.innerHeight];
  const inside = (left: number, top: number) => ({
    left: Math.max(GAP, Math.min(width - CARD.width - GAP, left)),
    top: Math.max(GAP, Math.min(height - cardHeight - GAP, top)),
  });
  if (box === null) return inside((width - CARD.width) / 2, (height - cardHeight) / 2);
  const middle = box.left + (box.width - CARD.width) / 2;
  if (box.top + box.height + GAP + cardHeight < height - GAP) return inside(middle, box.top + box.height + GAP);
  if (box.top - GAP - cardHeight > GAP) return inside(middle, box.top - GAP - cardHeight);
  if (box.left + box.width + GAP + CARD.width < width) return inside(box.left + box.width + GAP, box.top + 40);
  if (box.left - GAP - CARD.width > 0) return inside(box.left - GAP - CARD.width, box.top + 40);
  return inside(middle, box.top + box.height - cardHeight - 60);
}

/** The tour of the editor, which starts by itself the first time. The page stays usable; Esc ends the tour. */
export function Tour() {
  const editor = useEditor();
  const { session, settings } = editor;
  const overlay = useSession((state) => state.overlay);
  const hasLevel = useStore(editor.open, (level) => level !== null);
  const isPlaying = useSession((state) => state.mode === 'play');
  const seen = useStore(settings, (state) => state.tourSeen);
  const isAsked = overlay === 'tour';
  // The tour resumes at the same step after a dialog.
  const [index, setIndex] = useState(0);
  if (!hasLevel || isPlaying || !(isAsked || (!seen && overlay === null))) return null;
  const end = () => {
    setIndex(0);
    settings.setState({ tourSeen: true });
    if (isAsked) session.setState({ overlay: null });
  };
  return <TourCard index={index} onIndex={setIndex} takesFocus={isAsked} onEnd={end} />;
}

interface TourCardProps {
  readonly index: number;
  readonly onIndex: (index: number) => void;
  readonly takesFocus: boolean;
  readonly onEnd: () => void;
}

function TourCard({ index, onIndex, takesFocus, onEnd }: TourCardProps) {
  const [box, setBox] = useState<Box | null>(null);
  const card = useRef<HTMLDivElement>(null);
  const [height, setHeight] = useState<number>(CARD.height);
  const isTouched = useCoarse();
  const { title, text, touch, at } = TOUR[index];
  const isLast = index === TOUR.length - 1;
  const ending = useRef(onEnd);
  ending.current = onEnd;

  useLayoutEffect(() => {
    const look = () => {
      setBox(find(at));
      if (card.current !== null) setHeight(card.current.offsetHeight);
    };
    look();
    // Dividers may be dragged, panels may appear and disappear.
    const timer = setInterval(look, 400);
    window.addEventListener('resize', look);
    return () => {
      clearInterval(timer);
      window.removeEventListener('resize', look);
    };
  }, [at]);
  useEffect(() => {
    if (takesFocus) card.current?.focus();
  }, [takesFocus]);
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || event.defaultPrevented) return;
      event.preventDefault();
      event.stopPropagation();
      ending.current();
    };
    window.addEventListener('keydown', onKey, { capture: true });
    return () => window.removeEventListener('keydown', onKey, { capture: true });
  }, []);

  const go = (by: number) => onIndex(Math.max(0, Math.min(TOUR.length - 1, index + by)));
  return (
    <>
      {box !== null && <div className="tour__ring" aria-hidden style={box} />}
      <div
        ref={card}
        className="tour"
        role="dialog"
        aria-modal="false"
        aria-label={`Tour, ${index + 1} of ${TOUR.length}: ${title}`}
        tabIndex={-1}
        style={placeCard(box, height)}
        onKeyDown={(event) => {
          if (event.key === 'ArrowRight') go(1);
          else if (event.key === 'ArrowLeft') go(-1);
          else return;
          event.preventDefault();
        }}
      >
        <h2 className="tour__title">{title}</h2>
        <p className="tour__text" aria-live="polite">
          {isTouched && touch !== undefined ? touch : text}
        </p>
        <div className="tour__buttons">
          <span className="tour__dots" aria-hidden>
            {TOUR.map((step, i) => (
              <i key={step.title} className={i === index ? 'tour__dot tour__dot--now' : 'tour__dot'} />
            ))}
          </span>
          {!isLast && (
            <Button hint="End the tour" shortcut={isTouched ? undefined : 'Esc'} onClick={onEnd}>
              Skip
            </Button>
          )}
          {index > 0 && (
            <Button hint="Previous step" look="outlined" onClick={() => go(-1)}>
              Back
            </Button>
          )}
          <Button hint={isLast ? 'End the tour' : 'Next step'} look="main" onClick={() => (isLast ? onEnd() : go(1))}>
            {isLast ? 'Done' : 'Next'}
          </Button>
        </div>
      </div>
    </>
  );
}
