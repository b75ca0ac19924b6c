import * as z from 'zod';
import {
  DELETE_REQUEST,
  DELETE_RESPONSE,
  type DeleteRequest,
  type DeleteResponse,
  EDIT_EVENTS,
  type EditEvent,
  ERROR_RESPONSE,
  type ErrorResponse,
  FOLDER_TERMS,
  type FolderTerms,
  KEY_RESPONSE,
  LEVEL_ENTRY,
  type LevelEntry,
  LIST_RESPONSE,
  type ListResponse,
  ORDER_REQUEST,
  ORDER_RESPONSE,
  type OrderRequest,
  type OrderResponse,
  PACK_ON_DISK,
  PACK_REQUEST,
  PACK_RESPONSE,
  type PackOnDisk,
  type PackRequest,
  type PackResponse,
  PUBLISH_REQUEST,
  PUBLISH_RESPONSE,
  type PublishRequest,
  type PublishResponse,
  READ_RESPONSE,
  REFUSED_LEVEL,
  RENAME_REQUEST,
  RESTORE_REQUEST,
  type ReadResponse,
  type RefusedLevel,
  type RenameRequest,
  type RestoreRequest,
  RUN_RESPONSE,
  TRASH_ENTRY,
  TRASH_RESPONSE,
  type TrashEntry,
  type TrashResponse,
  WRITE_REQUEST,
  WRITE_RESPONSE,
  type WriteRequest,
  type WriteResponse,
} from './edit-api/index.ts';
import type { Shape, ValueOf } from './level/index.ts';
import { schemaOf } from './level-schema.ts';

// The protocol of `gq edit` as zod schemas.

const zodOf = <const S extends Shape>(shape: S): z.ZodType<ValueOf<S>> => schemaOf(shape, '', {}) as z.ZodType<ValueOf<S>>;

/** The zod schema of a {@link LevelEntry}. */
export const levelEntrySchema: z.ZodType<LevelEntry> = zodOf(LEVEL_ENTRY);
/** The zod schema of a {@link PackOnDisk}. */
export const packOnDiskSchema: z.ZodType<PackOnDisk> = zodOf(PACK_ON_DISK);
/** The zod schema of a {@link FolderTerms}. */
export const folderTermsSchema: z.ZodType<FolderTerms> = zodOf(FOLDER_TERMS);
/** The zod schema of a {@link ListResponse}. */
export const listResponseSchema: z.ZodType<ListResponse> = zodOf(LIST_RESPONSE);
/** The zod schema of a {@link ReadResponse}. */
export const readResponseSchema: z.ZodType<ReadResponse> = zodOf(READ_RESPONSE);
/** The zod schema of a {@link WriteRequest}. */
export const writeRequestSchema: z.ZodType<WriteRequest> = zodOf(WRITE_REQUEST);
/** The zod schema of a {@link WriteResponse}. */
export const writeResponseSchema: z.ZodType<WriteResponse> = zodOf(WRITE_RESPONSE);
/** The zod schema of a {@link RenameRequest}. */
export const renameRequestSchema: z.ZodType<RenameRequest> = zodOf(RENAME_REQUEST);
/** The zod schema of a {@link DeleteRequest}. */
export const deleteRequestSchema: z.ZodType<DeleteRequest> = zodOf(DELETE_REQUEST);
/** The zod schema of a {@link TrashEntry}. */
export const trashEntrySchema: z.ZodType<TrashEntry> = zodOf(TRASH_ENTRY);
/** The zod schema of a {@link DeleteResponse}. */
export const deleteResponseSchema: z.ZodType<DeleteResponse> = zodOf(DELETE_RESPONSE);
/** The zod schema of a {@link TrashResponse}. */
export const trashResponseSchema: z.ZodType<TrashResponse> = zodOf(TRASH_RESPONSE);
/** The zod schema of a {@link RestoreRequest}. */
export const restoreRequestSchema: z.ZodType<RestoreRequest> = zodOf(RESTORE_REQUEST);
/** The zod schema of a {@link OrderRequest}. */
export const orderRequestSchema: z.ZodType<OrderRequest> = zodOf(ORDER_REQUEST);
/** The zod schema of a {@link OrderResponse}. */
export const orderResponseSchema: z.ZodType<OrderResponse> = zodOf(ORDER_RESPONSE);
/** The zod schema of a {@link PackRequest}. */
export const packRequestSchema: z.ZodType<PackRequest> = zodOf(PACK_REQUEST);
/** The zod schema of a {@link PackResponse}. */
export const packResponseSchema: z.ZodType<PackResponse> = zodOf(PACK_RESPONSE);
/** The zod schema of a {@link PublishRequest}. */
export const publishRequestSchema: z.ZodType<PublishRequest> = zodOf(PUBLISH_REQUEST);
/** The zod schema of a {@link PublishResponse}. */
export const publishResponseSchema: z.ZodType<PublishResponse> = zodOf(PUBLISH_RESPONSE);
/** The zod schema of a {@link RefusedLevel}. */
export const refusedLevelSchema: z.ZodType<RefusedLevel> = zodOf(REFUSED_LEVEL);
/** The zod schema of a {@link ErrorResponse}. */
export const errorResponseSchema: z.ZodType<ErrorResponse> = zodOf(ERROR_RESPONSE);
/** The zod schema of the response to `GET KEY`. */
export const keyResponseSchema: z.ZodType<ValueOf<typeof KEY_RESPONSE>> = zodOf(KEY_RESPONSE);
/** The zod schema of the response to `GET RUN`. */
export const runResponseSchema: z.ZodType<ValueOf<typeof RUN_RESPONSE>> = zodOf(RUN_RESPONSE);
/** The zod schema of an {@link EditEvent}. */
export const editEventSchema: z.ZodType<EditEvent> = z.union(Object.values(EDIT_EVENTS).map(zodOf));
