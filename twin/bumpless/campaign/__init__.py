"""Many drawn missions: declared in a file, flown on Dask, kept as Parquet, summed up on a page, tuned by."""
