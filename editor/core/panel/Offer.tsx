import { Check, Eye, Undo2 } from 'lucide-react';
import { type ReactNode, useEffect, useRef } from 'react';
import { Button } from '../ui/index.ts';
import './offers.css';

interface OfferProps {
  /** What would be changed, as a sentence. */
  readonly text: string;
  /** Its size, and what the run is like then. */
  readonly figures: ReactNode;
  readonly figuresTitle?: string;
  readonly isShown: boolean;
  /** null: it can't be shown any more */
  readonly onPreview: (() => void) | null;
  readonly onBack: () => void;
  readonly onTake: () => void;
}

/** A change that the page offers: it can be previewed, and then taken or not. An item of a list. */
export function Offer({ text, figures, figuresTitle, isShown, onPreview, onBack, onTake }: OfferProps) {
  const item = useRef<HTMLLIElement>(null);
  const wasShown = useRef(isShown);
  // the button that was pressed is gone: the next one takes its place
  useEffect(() => {
    const isFree = document.activeElement === document.body || item.current?.parentElement?.contains(document.activeElement);
    if (isShown !== wasShown.current && isFree) item.current?.querySelector<HTMLElement>('button:last-of-type')?.focus();
    wasShown.current = isShown;
  }, [isShown]);
  return (
    <li ref={item} className={isShown ? 'offer offer--previewed' : 'offer'}>
      <span className="offer__text">{text}</span>
      <div className="offer__row">
        <span className="part__note numbers" title={figuresTitle}>
          {figures}
        </span>
        {isShown ? (
          <span className="offer__does">
            <Button hint="Go back to the level as it is" icon={<Undo2 size={14} />} onClick={onBack}>
              Back
            </Button>
            <Button hint="Keep this change: one step of undo" icon={<Check size={14} />} look="outlined" onClick={onTake}>
              Take
            </Button>
          </span>
        ) : (
          onPreview !== null && (
            <Button
              hint="Show the level with this change; nothing is saved yet"
              hintSide="left"
              icon={<Eye size={14} />}
              look="outlined"
              onClick={onPreview}
            >
              Preview
            </Button>
          )
        )}
      </div>
    </li>
  );
}
