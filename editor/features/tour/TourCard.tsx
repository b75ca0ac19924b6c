import { useEffect, useLayoutEffect, useRef, useState } from 'react';
import { useCoarse } from '../../core/context/index.ts';
import { Button } from '../../core/ui/index.ts';

interface ScreenBox {
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
function find(selectors: readonly string[]): ScreenBox | null {
  for (const selector of selectors) {
    const element = document.querySelector(selector);
    const box = element?.getBoundingClientRect();
    if (box !== undefined && box.width > 0) return { left: box.left, top: box.top, width: box.width, height: box.height };
  }
  return null;
}

/** Places the card where there is room beside the box: below, above, right or left of it, or else within it. */
function placeCard(box: ScreenBox | null, cardHeight: number): { left: number; top: number } {
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

interface TourCardProps {
  readonly index: number;
  readonly onIndex: (index: number) => void;
  readonly takesFocus: boolean;
  readonly onEnd: () => void;
}

export function TourCard({ index, onIndex, takesFocus, onEnd }: TourCardProps) {
  const [box, setBox] = useState<ScreenBox | null>(null);
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

/** One step of the tour: a place on the page and what to know about it. */
interface TourStep {
  readonly title: string;
  readonly text: string;
  /** The text for touch, where it differs. */
  readonly touch?: string;
  /** Selectors of the place, the first that matches counts; none: the middle of the page. */
  readonly at: readonly string[];
}

/** A tour of the whole editor in under a minute. */
const TOUR: readonly TourStep[] = [
  {
    title: 'Build the level here',
    text: 'Drag an object to move it, drag its rim to resize it. Scroll to zoom, drag with the right button to move the view, click with it for a menu.',
    touch:
      'Drag an object to move it, drag its rim to resize it. Drag on empty space to move the view, pinch to zoom, rest a finger for a menu.',
    at: ['[aria-label="Level canvas"]'],
  },
  {
    title: 'Add objects',
    text: 'Choose a tool and click on the canvas, or drag the tool there. Each tool has a key: A for an asteroid, N for a nova, M for a mineral.',
    touch:
      'Choose a tool, such as an asteroid, a nova or a mineral, and tap on the canvas to place it. The arrow goes back to selecting.',
    at: ['[role=toolbar][aria-label="Tools"]'],
  },
  {
    title: 'The verdict is always live',
    text: 'The line shows the path of the run. It follows while you drag, and so does the verdict, which is the one that gq check gives. The dashed line is the path before the drag, with what is better and worse beside it. The heart in the timeline keeps the run alive meanwhile.',
    at: ['[aria-label^="Verdict"]'],
  },
  {
    title: 'A run is a row of holds',
    text: 'Each bar is a hold of the gun. Drag it to move it, drag its ends to stretch it; hold Alt to move everything after it as well. Click the ruler to see any moment. C compares with another run, T shows the run as text.',
    touch: 'Each bar is a hold of the gun. Drag it to move it, drag its ends to stretch it. Tap the ruler to see any moment.',
    at: ['section[aria-label="Timeline"]', '.narrow__sheet--timeline', '.narrow__tabs'],
  },
  {
    title: 'Play it right here',
    text: 'Press Space to play, Esc to return. Hold the mouse button or one of a gamepad to hold the gun; [ plays in slow motion. You can keep each attempt as a run of the level.',
    touch:
      'Tap Play to start, and again to return. Hold a finger down to hold the gun. You can keep each attempt as a run of the level.',
    at: ['.topbar .button--main'],
  },
  {
    title: 'Levels, objects, numbers',
    text: 'Here are all levels with their verdicts, also as cards in order, all objects, the numbers of what is selected, the problems, and a solver that searches for runs.',
    at: ['aside[aria-label="Levels and objects"]', '.narrow__tabs'],
  },
  {
    title: 'Find any command',
    text: 'Press Ctrl+K to find any command, ? for all shortcuts. Every change is saved at once and can be undone; Y shows earlier versions. Have fun!',
    touch: 'Tap the magnifier to find any command, also the history. Every change is saved at once and can be undone. Have fun!',
    at: ['.topbar__search'],
  },
];
