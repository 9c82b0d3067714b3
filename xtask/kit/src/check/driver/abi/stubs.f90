! Utility routines of Abaqus that user subroutines call, for programs without Abaqus. Leave out this file where you have
! your own.

! Ends the program, as it ends the analysis.
subroutine xit()
    error stop 'XIT is called'
end subroutine xit

! Prints a message; LOP = -3 ends the program. %I, %R and %S in it stand for the numbers and texts, which are not shown.
subroutine stdb_abqerr(lop, message, integers, numbers, texts)
    use, intrinsic :: iso_fortran_env, only: error_unit
    integer, intent(in) :: lop, integers(*)
    character(len=*), intent(in) :: message, texts(*)
    real(kind(1.0d0)), intent(in) :: numbers(*)
    write (error_unit, '(a)') trim(message)
    if (lop == -3) error stop 'STDB_ABQERR ends the analysis'
    ! Nothing of these is looked at.
    if (.false.) write (error_unit, *) integers(1), numbers(1), texts(1)
end subroutine stdb_abqerr

! There are no variables of material points: JRCD = 1 says so.
subroutine getvrm(variable, array, jarray, flags, jrcd, jmac, jmatyp, matlayo, laccfla)
    character(len=*), intent(in) :: variable
    real(kind(1.0d0)), intent(out) :: array(15)
    integer, intent(out) :: jarray(15), jrcd
    character(len=3), intent(out) :: flags(15)
    integer, intent(in) :: jmac(*), jmatyp(*), matlayo, laccfla
    array = 0
    jarray = 0
    flags = ' '
    jrcd = 1
    if (.false.) write (*, *) variable, jmac(1), jmatyp(1), matlayo, laccfla
end subroutine getvrm

! The name of the job and the folder of its results.
subroutine getjobname(name, length)
    character(len=*), intent(out) :: name
    integer, intent(out) :: length
    name = 'job'
    length = 3
end subroutine getjobname

subroutine getoutdir(folder, length)
    character(len=*), intent(out) :: folder
    integer, intent(out) :: length
    folder = '.'
    length = 1
end subroutine getoutdir
