import { EllipsisVertical } from 'lucide-react';
import { memo } from 'react';
import { showMenu } from './show-menu.ts';

/** Opens the context menu of its row. It is not focusable, as the keyboard has the menu key. */
export const MoreButton = memo(function MoreButton() {
  return (
    <button
      type="button"
      className="tree__more"
      tabIndex={-1}
      aria-hidden
      // the focus stays in the tree, which handles the keys
      onMouseDown={(event) => event.preventDefault()}
      onDoubleClick={(event) => event.stopPropagation()}
      onClick={(event) => {
        event.stopPropagation();
        showMenu(event.currentTarget);
      }}
    >
      <EllipsisVertical size={14} />
    </button>
  );
});
